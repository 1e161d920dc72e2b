// none.c - replaces the modules of this folder, except watch.c, on a machine without GLFW, where no
// window can be opened.
#include "window/window.h"

#include "report.h"
#include "window/keys.h"

const struct key_row window_keys[] = {{0}};

struct window *window_open(struct context *context, const struct window_start *start)
{
    (void)context;
    report("%s: built without GLFW, so it cannot open windows: run make setup, then make",
           start->title);
    return NULL;
}

void window_show(struct window *window, const struct window_start *start, bool at_last)
{
    (void)window;
    (void)start;
    (void)at_last;
}

int window_asked(struct window *window, int *part, int *scene)
{
    *part = *scene = 0;
    return window != NULL;
}

bool window_idles(const struct window *window)
{
    return window != NULL;
}

void window_warn(struct window *window, const char *text)
{
    (void)window;
    (void)text;
}

void window_fill_screen(struct window *window)
{
    (void)window;
}

bool window_run(struct window *window, void (*turned)(void *to), void *to)
{
    (void)turned;
    (void)to;
    return window != NULL;
}

void window_close(struct window *window)
{
    (void)window;
}
