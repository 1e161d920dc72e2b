#include "window/stroke.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "picture/comparison.h"
#include "picture/probe.h"
#include "picture/renderer_ray.h"

#define SPACING 0.5 // minimum distance between a stroke's points, divided by the stroke's amount

// Return the parameter that sets the tool's amount, or NULL if there is none.
static const struct parameter *amount_of(const struct window *window)
{
    const struct sculpture_tool *tool = window->renderer->sculpture.tool;
    return tool != NULL ? parameters_find(&window->renderer->parameters, tool->amount) : NULL;
}

bool window_has_tool(const struct window *window)
{
    const struct parameter *amount = amount_of(window);
    return amount != NULL && fabs(amount->value[0]) > 0.0 &&
           !shader_shows_ray(window->renderer->view);
}

// Find the point of the volume under the pointer. Returns false if there is no such point, as when
// the pointer has been dragged out of the window.
static bool aim(struct window *window, double point[3])
{
    const struct renderer_inputs *inputs = &window->inputs;
    double x = floor(window->pointer.last[0]), y = ceil(window->pointer.last[1]) - 1.0;
    if (!(x >= 0.0 && y >= 0.0 && x < inputs->width && y < inputs->height))
        return false;
    struct renderer *renderer = renderer_at(window->renderer, inputs->width, (int)x);
    const struct sculpture *sculpture = &renderer->sculpture;
    struct probe *probe = memory_zeros(1, sizeof *probe);
    bool met = renderer_sculpt(renderer, inputs) && sculpture->now != NULL &&
               renderer_march(renderer, inputs, (int)x, (int)y, probe) && probe_rows(probe) > 0;
    if (met) {
        struct sculpture_aim aim = {.time = inputs->time, .parameters = &renderer->parameters};
        for (int i = 0; i < 3; i++) {
            aim.eye[i] = (double)inputs->camera.position[i];
            aim.point[i] = (double)probe->step[probe_rows(probe) - 1].position[i];
        }
        met = sculpture->tool->aim(sculpture->points > 0 ? sculpture->before : sculpture->now, &aim,
                                   point);
    }
    free(probe);
    return met;
}

static void add(struct window *window, const double point[3])
{
    strokes_add(window->start->strokes, point);
    window->moved = window->stale = window->dirty = true;
}

bool window_stroke_claims(struct window *window, const struct window_event *press)
{
    struct strokes *strokes = window->start->strokes;
    double point[3];
    if (!window_has_tool(window))
        return false;
    memcpy(window->pointer.last, press->pixel, sizeof press->pixel);
    strokes_begin(strokes, amount_of(window)->value[0]);
    bool begins = aim(window, point);
    if (begins)
        add(window, point);
    else
        strokes_take_back(strokes, 1);
    return begins;
}

void window_stroke_input(struct window *window, const struct window_event *event)
{
    memcpy(window->pointer.last, event->pixel, sizeof event->pixel);
    window_stroke_rest(window); // for every point of the path, also if a frame takes long
    if (event->kind != EVENT_RELEASE)
        return;
    const struct strokes *strokes = window->start->strokes;
    char *text = stroke_text(&strokes->item[strokes->count - 1]);
    printf("--stroke %s\n", text);
    fflush(stdout);
    free(text);
}

void window_stroke_rest(struct window *window)
{
    const struct strokes *strokes = window->start->strokes;
    double point[3], squared = 0.0;
    if (window->pointer.owner != OWNER_STROKE || !aim(window, point))
        return;
    const struct stroke *stroke = &strokes->item[strokes->count - 1];
    for (int i = 0; i < 3; i++) {
        double difference = point[i] - stroke->point[stroke->points - 1][i];
        squared += difference * difference;
    }
    if (sqrt(squared) >= SPACING * fabs(stroke->amount))
        add(window, point);
}

void window_take_back(struct window *window, int count)
{
    if (window->pointer.owner == OWNER_STROKE)
        return;
    strokes_take_back(window->start->strokes, count);
    window->moved = window->stale = window->dirty = true;
}
