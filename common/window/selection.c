#include "window/selection.h"

#include <stdio.h>
#include <string.h>

#include "picture/comparison.h"
#include "report.h"

struct parameter *window_selected(const struct window *window)
{
    const struct renderer *renderer = window->renderer;
    struct parameter *parameter;
    for (int i = 0; (parameter = comparison_parameter(renderer, i)) != NULL; i++)
        if (strcmp(parameter->name, window->parameter) == 0 &&
            (comparison_parameter_side(renderer, parameter) == 1) == window->second)
            return parameter;
    return comparison_parameter(renderer, 0);
}

int window_selected_part(const struct window *window)
{
    const struct parameter *parameter = window_selected(window);
    bool vector = parameter != NULL && parameter->components > 1;
    return vector && window->part < parameter->components ? window->part : -1;
}

void window_copy_parts(struct parameter *parameter, const double value[4], int part)
{
    for (int k = 0; k < parameter->components; k++)
        if (part < 0 || part == k)
            parameter->value[k] = value[k];
}

void window_select(struct window *window, const struct parameter *parameter, int part)
{
    snprintf(window->parameter, sizeof window->parameter, "%s", parameter->name);
    window->part = part;
    window->second = comparison_parameter_side(window->renderer, parameter) == 1;
    window->dirty = true;
    window->title.due = 0.0;
}

struct parameter *window_grabbed(const struct window *window, int *first, int *end)
{
    struct parameter *parameter = window_selected(window);
    int part = window->grab.part;
    if (parameter == NULL || part >= parameter->components)
        return NULL;
    *first = part < 0 ? 0 : part;
    *end = part < 0 ? parameter->components : part + 1;
    return parameter;
}

void window_parameter_changed(struct window *window)
{
    const struct parameter *parameter = window_selected(window);
    window->transition.on = false;
    if (parameter != NULL)
        window_begin_hour(window, parameter);
    window->moved = window->stale = window->dirty = true;
    window->title.due = 0.0;
}

void window_begin_hour(struct window *window, const struct parameter *parameter)
{
    if (parameter_is_hour(parameter))
        window->inputs.begin = window->inputs.time = 0.0;
}

void window_show_view(struct window *window, int view)
{
    bool shown = renderer_set_view(window->renderer, (enum shader_view)view);
    window->stale = true;
    if (!shown || !window->broken)
        snprintf(window->panel.error, sizeof window->panel.error, "%s", shown ? "" : report_last());
}
