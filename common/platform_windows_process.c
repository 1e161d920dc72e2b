// platform.h for Windows: where the program begins, its clocks, its console, and what may happen to
// the process.
#include "platform.h"

#include <fcntl.h>
#include <io.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>
// Behind it, for they need it.
#include <shellapi.h>
#include <timeapi.h>

#define STACK_LEFT (64 * 1024) // bytes for on_crash, when the driver has used up the rest
#define SINCE_1601 11644473600 // of 1970, in seconds

// Laptops with two graphics cards give a program that exports these the faster one.
__declspec(dllexport) extern const DWORD NvOptimusEnablement, AmdPowerXpressRequestHighPerformance;
const DWORD NvOptimusEnablement = 1, AmdPowerXpressRequestHighPerformance = 1;

static struct {
    const char *words, *lost_page;
    UINT code_page; // of the console, before
    bool done;      // main has come to a good end
} state;

// ---- The console ----

static void say(const char *words)
{
    DWORD written;
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), words, (DWORD)strlen(words), &written, NULL);
}

static bool is_console(DWORD which)
{
    DWORD mode;
    return GetConsoleMode(GetStdHandle(which), &mode);
}

// A console that was opened for this program goes with it: whoever reads an error there is waited
// for.
static void wait_for_reader(void)
{
    DWORD others[2], read;
    char key;
    if (GetConsoleProcessList(others, 2) != 1 || !is_console(STD_ERROR_HANDLE) ||
        !is_console(STD_INPUT_HANDLE))
        return;
    say("\nPress Enter to close this window.\n");
    ReadFile(GetStdHandle(STD_INPUT_HANDLE), &key, 1, &read, NULL);
}

static void leave_console(void)
{
    fflush(stdout);
    if (!state.done)
        wait_for_reader();
    if (state.code_page != 0)
        SetConsoleOutputCP(state.code_page);
}

bool platform_is_terminal(FILE *stream)
{
    DWORD mode;
    return GetConsoleMode((HANDLE)_get_osfhandle(_fileno(stream)), &mode);
}

enum platform_display platform_display(void)
{
    return PLATFORM_OWN_DISPLAY;
}

// ---- Where the program begins ----

int main(int argc, char **argv);

static void *need(void *memory)
{
    if (memory == NULL) {
        say("not enough memory: close other programs\n");
        exit(1);
    }
    return memory;
}

// A word of the command line in UTF-8, with '/' between the parts of a path: of all that can be
// said there only paths have a '\'. Lives as long as the program.
static char *word_of(const wchar_t *wide)
{
    int size = WideCharToMultiByte(CP_UTF8, 0, wide, -1, NULL, 0, NULL, NULL);
    char *word = need(malloc((size_t)size + 1));
    WideCharToMultiByte(CP_UTF8, 0, wide, -1, word, size, NULL, NULL);
    for (char *at = word; *at != '\0'; at++)
        if (*at == '\\')
            *at = '/';
    return word;
}

// The words of the command line as the shell gave them: the C library would look for files that *
// and ? stand for.
static char **words_of(int *count)
{
    wchar_t **wide = need(CommandLineToArgvW(GetCommandLineW(), count));
    char **words = need(calloc((size_t)*count + 1, sizeof *words));
    for (int i = 0; i < *count; i++)
        words[i] = word_of(wide[i]);
    LocalFree(wide);
    return words;
}

// The C library begins here. Output is written as it stands, in UTF-8.
int wmain(void)
{
    int count = 0;
    char **words = words_of(&count);
    _setmode(_fileno(stdout), _O_BINARY);
    _setmode(_fileno(stderr), _O_BINARY);
    SetErrorMode(SEM_FAILCRITICALERRORS); // a drive without a disk is a file that is not there
    timeBeginPeriod(1);                   // else a wait may be as long as a picture, 16 ms
    state.code_page = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    atexit(leave_console);
    int status = main(count, words);
    state.done = status == 0;
    return status;
}

void platform_set(const char *name, const char *value, bool over)
{
    if (over || getenv(name) == NULL)
        _putenv_s(name, value);
}

// ---- Clocks ----

static double seconds_of(FILETIME time)
{
    return 1e-7 * (4294967296.0 * time.dwHighDateTime + time.dwLowDateTime);
}

double platform_processor_seconds(void)
{
    FILETIME begin, end, kernel = {0}, user = {0};
    GetProcessTimes(GetCurrentProcess(), &begin, &end, &kernel, &user);
    return seconds_of(kernel) + seconds_of(user);
}

double platform_seconds(void)
{
    LARGE_INTEGER now, frequency;
    QueryPerformanceCounter(&now);
    QueryPerformanceFrequency(&frequency);
    return (double)now.QuadPart / (double)frequency.QuadPart;
}

double platform_date(struct tm *date)
{
    FILETIME now;
    GetSystemTimePreciseAsFileTime(&now);
    unsigned long long ticks = (unsigned long long)now.dwHighDateTime << 32 | now.dwLowDateTime;
    time_t seconds = (time_t)(ticks / 10000000) - SINCE_1601;
    localtime_s(date, &seconds);
    return 1e-7 * (double)(ticks % 10000000);
}

// ---- What may happen to the process ----

static LONG WINAPI on_crash(EXCEPTION_POINTERS *what)
{
    bool lost = what->ExceptionRecord->ExceptionCode == EXCEPTION_IN_PAGE_ERROR;
    const char *words = lost ? state.lost_page : state.words;
    if (words == NULL)
        return EXCEPTION_CONTINUE_SEARCH;
    say(words);
    wait_for_reader();
    TerminateProcess(GetCurrentProcess(), 1);
    return EXCEPTION_EXECUTE_HANDLER;
}

void platform_watch_crash(const char *words)
{
    ULONG left = STACK_LEFT;
    SetThreadStackGuarantee(&left);
    state.words = words;
    SetUnhandledExceptionFilter(on_crash);
}

void platform_watch_lost_page(const char *words)
{
    state.lost_page = words;
    SetUnhandledExceptionFilter(on_crash);
}

size_t platform_stack(void)
{
    ULONG_PTR low, high;
    GetCurrentThreadStackLimits(&low, &high);
    return (size_t)(high - low);
}

int platform_processors(void)
{
    return (int)GetActiveProcessorCount(ALL_PROCESSOR_GROUPS);
}

// Nothing but memory limits them.
bool platform_has_threads(int count)
{
    return count >= 0;
}

void platform_limit_memory(double more)
{
    (void)more;
}

void platform_free_memory(void)
{
}
