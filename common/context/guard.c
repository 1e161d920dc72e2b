#include "context/guard.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "memory.h"
#include "platform.h"
#include "report.h"

#define MEMORY_MOST 4e9 // additional bytes that a driver may use to compile a shader

static char message[1024]; // printed if the driver crashes between guard_begin and guard_end
static char outside[256];  // printed if it crashes elsewhere; "" if nothing is printed

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
    // Nothing but a limit has yet been seen to crash a driver while it draws.
    if (memory_limit()[0] != '\0')
        snprintf(outside, sizeof outside, "the graphics driver crashed%s\n", memory_limit());
    guard_end();
}

void guard_memory(void)
{
    platform_limit_memory(MEMORY_MOST);
}

void guard_begin(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message - 256, format, arguments);
    va_end(arguments);
    report_clean(message, sizeof message, message);
    memory_append(message, sizeof message, "%s\n", memory_limit());
    platform_watch_crash(message);
}

void guard_end(void)
{
    platform_free_memory();
    platform_watch_crash(outside[0] != '\0' ? outside : NULL);
}
