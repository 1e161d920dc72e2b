#include "lib/system.h"

#include <direct.h>
#include <errno.h>
#include <process.h>
#include <stdio.h>
#include <stdlib.h>

bool system_make_scratch(char path[PLATFORM_PATH])
{
    static int number;
    const char *parent = getenv("TEMP");
    // The name may be taken: the id of an ended program can be reused, and a killed program leaves
    // its folder behind.
    bool made;
    do {
        snprintf(path, PLATFORM_PATH, "%s/march-test-%d-%d", parent != NULL ? parent : ".",
                 _getpid(), number++);
        made = system_make_folder(path);
    } while (!made && errno == EEXIST);
    char *resolved = made ? platform_resolve(path) : NULL;
    if (resolved != NULL)
        snprintf(path, PLATFORM_PATH, "%s", resolved);
    free(resolved);
    return resolved != NULL;
}

// tmpfile cannot be used, because Wine's version may return the same file to two programs that run
// at once.
FILE *system_open_scratch(void)
{
    static int number;
    char path[PLATFORM_PATH];
    const char *parent = getenv("TEMP");
    FILE *file;
    do {
        snprintf(path, sizeof path, "%s/march-test-%d-%d.tmp", parent != NULL ? parent : ".",
                 _getpid(), number++);
        file = fopen(path, "w+bxD"); // a new file, deleted when it is closed
    } while (file == NULL && errno == EEXIST);
    if (file == NULL) {
        perror(path);
        abort();
    }
    return file;
}

bool system_make_folder(const char *path)
{
    return _mkdir(path) == 0;
}

bool system_remove_folder(const char *path)
{
    char command[PLATFORM_PATH + 32];
    int begin = snprintf(command, sizeof command, "rmdir /s /q ");
    snprintf(command + begin, sizeof command - (size_t)begin, "\"%s\"", path);
    for (char *c = command + begin; *c != '\0'; c++)
        if (*c == '/')
            *c = '\\';
    return system(command) == 0;
}

int system_open_files(void)
{
    printf("# open files are not counted: Windows has no /proc/self/fd\n");
    return -1;
}

// The programs are run by cmd, which treats '/' as the beginning of an option.
int system_run(const char *program, const char *arguments, char *text, size_t size)
{
    char command[PLATFORM_PATH];
    const char *build = getenv("BUILD");
    int length =
        snprintf(command, sizeof command, "%s\\%s", build != NULL ? build : "build", program);
    for (char *c = command; *c != '\0'; c++)
        if (*c == '/')
            *c = '\\';
    snprintf(command + length, sizeof command - (size_t)length, " %s 2>&1", arguments);
    FILE *pipe = _popen(command, "r");
    if (pipe == NULL) {
        perror(command);
        abort();
    }
    text[fread(text, 1, size - 1, pipe)] = '\0';
    return _pclose(pipe);
}

// On Windows, only administrators can make links, and a pipe is not a file in a folder.
bool system_make_link(const char *to, const char *path)
{
    (void)to, (void)path;
    return false;
}

bool system_make_pipe(const char *path)
{
    (void)path;
    return false;
}
