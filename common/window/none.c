// Replaces window.c on a machine without GLFW, where no window can be opened.
#include "window/window.h"

#include "report.h"

struct window *window_open(struct context *context, const struct window_start *start)
{
    (void)context;
    report("%s: built without GLFW, so it cannot open windows: run make setup, then make",
           start->title);
    return NULL;
}

bool window_run(struct window *window)
{
    return window != NULL;
}

void window_close(struct window *window)
{
    (void)window;
}
