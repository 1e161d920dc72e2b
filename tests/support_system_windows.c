#include "support_system.h"

#include <direct.h>
#include <process.h>
#include <stdio.h>
#include <stdlib.h>

bool system_make_scratch(char path[PLATFORM_PATH])
{
    static int number;
    const char *parent = getenv("TEMP");
    snprintf(path, PLATFORM_PATH, "%s/march-test-%d-%d", parent != NULL ? parent : ".", _getpid(),
             number++);
    char *resolved = system_make_folder(path) ? platform_resolve(path) : NULL;
    if (resolved != NULL)
        snprintf(path, PLATFORM_PATH, "%s", resolved);
    free(resolved);
    return resolved != NULL;
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

// It has links for administrators alone, and no pipe that is a file of a folder.
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
