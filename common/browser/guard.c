// Replaces context/guard.c in a browser, whose driver runs in another process. If the driver
// crashes, the page receives the event webglcontextlost.
#include "context/guard.h"

void guard_process(void)
{
}

void guard_forget_caches(void)
{
}

void guard_begin(const char *format, ...)
{
    (void)format;
}

void guard_end(void)
{
}

void guard_memory(void)
{
}
