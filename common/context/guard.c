#include "context/guard.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "platform.h"

#define MEMORY_MOST 4e9 // additional bytes that a driver may use to compile a shader

static char message[1024]; // printed if the driver crashes

void guard_forget_caches(void)
{
    platform_set("MESA_SHADER_CACHE_DISABLE", "true", true);
    platform_set("MESA_GLSL_CACHE_DISABLE", "true", true);
    platform_set("__GL_SHADER_DISK_CACHE", "0", true);
}

void guard_process(void)
{
    // Mesa's shader cache is a file that is mapped into memory.
    platform_watch_lost_page(
        "the graphics driver lost its shader cache: is the disk of the cache full? "
        "set MESA_SHADER_CACHE_DISABLE=true\n");
    platform_watch_short_memory(
        "the graphics driver crashed: the memory of this process is limited: "
        "raise the limit (ulimit -v)\n");
}

void guard_memory(void)
{
    platform_limit_memory(MEMORY_MOST);
}

void guard_begin(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message - 1, format, arguments);
    va_end(arguments);
    strcat(message, "\n");
    platform_watch_crash(message);
}

void guard_end(void)
{
    platform_free_memory();
    platform_watch_crash(NULL);
}
