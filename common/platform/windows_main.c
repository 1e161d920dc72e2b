// The entry point of a program for Windows, which calls main with the command line in UTF-8. In the
// packed folder, every program contains this file, and a library beside the programs contains the
// rest of the code.
#include "platform/windows.h"

#include <fcntl.h>
#include <io.h>
#include <stdlib.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>
// These headers must follow windows.h.
#include <shellapi.h>
#include <timeapi.h>

// On laptops with two graphics cards, a program that exports these variables gets the faster one.
__declspec(dllexport) extern const DWORD NvOptimusEnablement, AmdPowerXpressRequestHighPerformance;
const DWORD NvOptimusEnablement = 1, AmdPowerXpressRequestHighPerformance = 1;

static struct {
    UINT code_page; // of the console before this program changed it
    bool done;      // main has succeeded
} state;

static void leave_console(void)
{
    fflush(stdout);
    if (!state.done)
        platform_wait_for_reader();
    if (state.code_page != 0)
        SetConsoleOutputCP(state.code_page);
}

int main(int argc, char **argv);

static void *need(void *memory)
{
    if (memory == NULL) {
        platform_message("not enough memory: close other programs\n");
        exit(1);
    }
    return memory;
}

// Return a word of the command line in UTF-8. Each '\' becomes '/', because only paths contain a
// '\'. The word lives as long as the program.
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

// Return the command line's words as the shell passed them. The C library would expand * and ?.
static char **words_of(int *count)
{
    wchar_t **wide = need(CommandLineToArgvW(GetCommandLineW(), count));
    char **words = need(calloc((size_t)*count + 1, sizeof *words));
    for (int i = 0; i < *count; i++)
        words[i] = word_of(wide[i]);
    LocalFree(wide);
    return words;
}

// The C library starts the program here. Output is written unchanged, in UTF-8.
int wmain(void)
{
    int count = 0;
    char **words = words_of(&count);
    _setmode(_fileno(stdout), _O_BINARY);
    _setmode(_fileno(stderr), _O_BINARY);
    setvbuf(stderr, NULL, _IONBF, 0);     // otherwise a pipe receives messages only at exit
    SetErrorMode(SEM_FAILCRITICALERRORS); // no dialog for a drive without a disk
    timeBeginPeriod(1);                   // otherwise a wait may last 16 ms, as long as a frame
    state.code_page = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    atexit(leave_console);
    int status = main(count, words);
    state.done = status == 0;
    return status;
}
