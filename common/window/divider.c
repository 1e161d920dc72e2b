// divider.c - the divider between the pictures of --compare: dragged by the mouse, and in a
// screenshot.
#include "window/state.h"

#include <math.h>

#include "picture/pair.h"

#define REACH 6.0 // window units beside the divider where a press takes it

bool window_at_divider(const struct window *window, const double place[2])
{
    const struct pair *pair = window->renderer->pair;
    int width = 0, height = 0;
    if (pair == NULL || place[0] < 0.0)
        return false;
    glfwGetWindowSize(window->handle, &width, &height);
    return fabs(place[0] - pair->divider * width) <= REACH;
}

void window_drag_divider(struct window *window, const double place[2])
{
    int width = 0, height = 0;
    glfwGetWindowSize(window->handle, &width, &height);
    double divider = width > 0 ? fmin(fmax(place[0] / width, 0.0), 1.0) : 0.5;
    window->moved |= divider != window->renderer->pair->divider;
    window->renderer->pair->divider = divider;
    window->ray.follow = window->dirty = true;
}

void window_label_pair(struct window *window)
{
    struct renderer *renderer = window->renderer;
    const struct renderer_inputs *inputs = &window->inputs;
    double scale = window->start->overlay_scale;
    if (renderer->pair == NULL || window->start->overlay_kept)
        return;
    pair_gather(renderer, &window->panel.overlay, inputs->width, inputs->height,
                scale > 0.0 ? (float)scale : overlay_scale_of(inputs->height));
    renderer->overlay = &window->panel.overlay;
}
