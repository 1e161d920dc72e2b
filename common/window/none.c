// Takes the place of window.c on a machine without GLFW, where no window can be opened.
#include "window/window.h"

#include "report.h"

bool window_run(struct context *context, struct renderer *renderer,
                const struct window_start *start)
{
    (void)context, (void)renderer;
    return report("%s: built without GLFW, which opens windows: run make setup, then make",
                  start->title);
}
