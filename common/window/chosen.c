// The parameter that arrows, pointer and title bar are about.
#include "window/state.h"

struct parameter *window_chosen(const struct window *window)
{
    const struct parameters *all = &window->renderer->parameters;
    struct parameter *parameter = parameters_find(all, window->parameter);
    return parameter != NULL || all->count == 0 ? parameter : &all->item[0];
}

struct parameter *window_taken(const struct window *window, int *first, int *behind)
{
    struct parameter *parameter = window_chosen(window);
    int part = window->touch.part;
    if (parameter == NULL || part >= parameter->components)
        return NULL;
    *first = part < 0 ? 0 : part;
    *behind = part < 0 ? parameter->components : part + 1;
    return parameter;
}

void window_changed(struct window *window)
{
    window->passage.on = false;
    window->moved = window->dirty = true;
    window->title.due = 0.0;
}
