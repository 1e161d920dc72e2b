// platform.h for Windows: clocks, console, crashes and memory.
#include "platform/windows.h"

#include <io.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#include <shellapi.h>

#define STACK_LEFT (64 * 1024) // bytes of stack for on_crash if the driver uses up the rest
#define SINCE_1601 11644473600 // the start of 1970, in seconds since 1601

static struct {
    const char *words, *lost_page;
} state;

// ---- The console ----

void platform_message(const char *words)
{
    DWORD written;
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), words, (DWORD)strlen(words), &written, NULL);
}

static bool is_console(DWORD which)
{
    DWORD mode;
    return GetConsoleMode(GetStdHandle(which), &mode);
}

void platform_wait_for_reader(void)
{
    DWORD others[2], read;
    char key;
    if (GetConsoleProcessList(others, 2) != 1 || !is_console(STD_ERROR_HANDLE) ||
        !is_console(STD_INPUT_HANDLE))
        return;
    platform_message("\nPress Enter to close this window.\n");
    ReadFile(GetStdHandle(STD_INPUT_HANDLE), &key, 1, &read, NULL);
}

bool platform_reader_left(void)
{
    DWORD written;
    if (WriteFile(GetStdHandle(STD_OUTPUT_HANDLE), "\n", 1, &written, NULL))
        return false;
    DWORD said = GetLastError();
    return said == ERROR_NO_DATA || said == ERROR_BROKEN_PIPE || said == ERROR_PIPE_NOT_CONNECTED;
}

void platform_outlive_reader(void)
{
}

void platform_watch_display(void (*lost)(const char *what))
{
    (void)lost;
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

// ---- Crashes and memory ----

static LONG WINAPI on_crash(EXCEPTION_POINTERS *what)
{
    bool lost = what->ExceptionRecord->ExceptionCode == EXCEPTION_IN_PAGE_ERROR;
    const char *words = lost ? state.lost_page : state.words;
    if (words == NULL)
        return EXCEPTION_CONTINUE_SEARCH;
    platform_message(words);
    platform_wait_for_reader();
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

double platform_memory_limit(char *option)
{
    (void)option;
    return HUGE_VAL;
}

void platform_limit_memory(double more)
{
    (void)more;
}

void platform_free_memory(void)
{
}

// ---- The editor ----

bool platform_edit(const char *path)
{
    wchar_t wide[PLATFORM_PATH];
    return MultiByteToWideChar(CP_UTF8, 0, path, -1, wide, PLATFORM_PATH) > 0 &&
           (INT_PTR)ShellExecuteW(NULL, L"open", wide, NULL, NULL, SW_SHOWNORMAL) > 32;
}
