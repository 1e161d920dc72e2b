// Replaces guard.c in a browser, whose driver runs in another process: if it crashes, the page gets
// an event.
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
