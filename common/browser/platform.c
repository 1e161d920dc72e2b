// Replaces platform/posix_process.c and platform/posix_display.c in a browser, which limits the
// memory of a page without telling the page, and has no X server.
#include "platform.h"

#include <math.h>

double platform_memory_limit(char *option)
{
    (void)option;
    return HUGE_VAL;
}

void platform_watch_display(void (*lost)(const char *what))
{
    (void)lost;
}
