// The parameter that arrows, pointer and title bar are about.
#include "window/state.h"

#include <stdio.h>
#include <string.h>

#include "picture/pair.h"

struct parameter *window_chosen(const struct window *window)
{
    const struct renderer *renderer = window->renderer;
    struct parameter *parameter;
    for (int i = 0; (parameter = pair_parameter(renderer, i)) != NULL; i++)
        if (strcmp(parameter->name, window->parameter) == 0 &&
            (pair_parameter_side(renderer, parameter) == 1) == window->second)
            return parameter;
    return pair_parameter(renderer, 0);
}

void window_choose(struct window *window, const struct parameter *parameter)
{
    snprintf(window->parameter, sizeof window->parameter, "%s", parameter->name);
    window->second = pair_parameter_side(window->renderer, parameter) == 1;
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
