// Takes the place of guard.c in a browser, whose driver works in a process of its own: one that
// dies takes the context with it, and the page hears of that.
#include "context/guard.h"

bool guard_stack(void)
{
    return true;
}

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
