// Takes the place of window.c on a machine without GLFW, where no window can be opened.
#include "window/window.h"

#include "report.h"

bool window_run(struct context *context, struct renderer *renderer, const struct options *options,
                const char *title, const char *stem, const char *shader)
{
    (void)context, (void)renderer, (void)options, (void)stem, (void)shader;
    report("%s: built without GLFW, which opens windows: run make setup, then make", title);
    return false;
}
