#include "context/guard.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform.h"
#include "report.h"

#define STACK_NEEDED (1024 * 1024) // bytes
#define CACHE_NEEDED 4e6           // bytes; the first file of Mesa's takes 1.3 million
#define MEMORY_MOST  4e9           // bytes that a driver may take for one program
#define THREADS_MOST 32            // that llvmpipe starts, one for each processor

static char said[1024]; // when the driver crashes

bool guard_stack(void)
{
    size_t stack = platform_stack();
    if (stack >= STACK_NEEDED)
        return true;
    return report(
        "the stack may take %zu KiB only, and %d are needed: allow more with ulimit -s 8192",
        stack / 1024, STACK_NEEDED / 1024);
}

// llvmpipe waits for ever for a thread that it could not start. Where it may not have all that it
// wants at the same time, it is told to do with none.
static void guard_threads(void)
{
    int processors = platform_processors();
    if (!platform_has_threads(processors < THREADS_MOST ? processors : THREADS_MOST))
        platform_set("LP_NUM_THREADS", "0", true);
}

// ---- Caches ----

void guard_forget_caches(void)
{
    platform_set("MESA_SHADER_CACHE_DISABLE", "true", true);
    platform_set("MESA_GLSL_CACHE_DISABLE", "true", true);
    platform_set("__GL_SHADER_DISK_CACHE", "0", true);
}

// Without room for the cache, do without it.
static void guard_cache(void)
{
    static const char *const folders[][2] = {
        {"MESA_SHADER_CACHE_DIR", ""}, {"XDG_CACHE_HOME", ""}, {"HOME", "/.cache"}, {"HOME", ""}};
    char path[PLATFORM_PATH];
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        const char *folder = getenv(folders[i][0]);
        if (folder == NULL ||
            snprintf(path, sizeof path, "%s%s", folder, folders[i][1]) >= (int)sizeof path)
            continue;
        double room = platform_room(path);
        if (room >= 0.0 && room < CACHE_NEEDED)
            guard_forget_caches();
        if (room >= 0.0)
            return;
    }
}

// ---- Crashes ----

void guard_process(void)
{
    // Mesa's shader cache is a file in memory.
    platform_watch_lost_page(
        "the graphics driver lost its memory: is the disk full that holds its cache of shaders? "
        "set MESA_SHADER_CACHE_DISABLE=true\n");
    guard_cache();
    guard_threads();
}

void guard_memory(void)
{
    platform_limit_memory(MEMORY_MOST);
}

void guard_begin(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(said, sizeof said - 1, format, arguments);
    va_end(arguments);
    strcat(said, "\n");
    platform_watch_crash(said);
}

void guard_end(void)
{
    platform_free_memory();
    platform_watch_crash(NULL);
}
