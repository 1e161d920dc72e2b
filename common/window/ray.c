#include "window/ray.h"

#include <math.h>
#include <stdio.h>

#include "picture/comparison.h"
#include "picture/renderer_ray.h"
#include "report.h"
#include "window/condition.h"
#include "window/frames.h"

// Show the ray again, in the overlay and in a picture that reads its march.
static void refresh(struct window *window)
{
    const struct renderer *renderer = window->renderer;
    window->ray.follow = window->dirty = true;
    window->stale |= shader_shows_ray(renderer->view) ||
                     renderer_reads(renderer, renderer->view, UNIFORM_iMarched);
}

void window_select_ray(struct window *window, const int pixel[2])
{
    const struct renderer_inputs *inputs = &window->inputs;
    const int size[2] = {inputs->width, inputs->height};
    for (int i = 0; i < 2; i++) {
        window->inputs.pixel[i] = pixel[i];
        window->ray.position[i] = (2.0 * pixel[i] + 1.0 - size[i]) / inputs->height;
    }
    window->ray.eye = renderer_eye_of(window->renderer, &window->inputs);
    window->inputs.eye = &window->ray.eye;
    window->inputs.shown = 0.0f;
    window->ray.why[0] = '\0';
    window->ray.print = true;
    refresh(window);
}

void window_deselect_ray(struct window *window)
{
    window->inputs.pixel[0] = window->inputs.pixel[1] = -1;
    window->inputs.eye = NULL;
    window->inputs.shown = 0.0f;
    window->ray.why[0] = '\0';
    window->ray.print = false;
    refresh(window);
}

void window_click_ray(struct window *window, const double pixel[2])
{
    const int *selected = window->inputs.pixel;
    const int clicked[2] = {(int)floor(pixel[0]), (int)ceil(pixel[1]) - 1};
    const struct shader_source *source = &window->renderer->fragment;
    if (source->dialect == DIALECT_COURSE && !source->marches)
        window_explain_key(window, KEY_WITH_MARCH);
    else if (clicked[0] == selected[0] && clicked[1] == selected[1])
        window_deselect_ray(window);
    else
        window_select_ray(window, clicked);
}

void window_resize_ray(struct window *window, int width, int height)
{
    int *pixel = window->inputs.pixel;
    const double *position = window->ray.position;
    if (pixel[0] < 0)
        return;
    pixel[0] = (int)floor(0.5 * (position[0] * height + width));
    pixel[1] = (int)floor(0.5 * (position[1] * height + height));
    if (pixel[0] < 0 || pixel[0] >= width)
        window_deselect_ray(window);
    else
        refresh(window);
}

// Return the number of steps of the selected ray; 0 if no ray is selected or it has no march.
static int steps_of(struct window *window)
{
    if (window->inputs.pixel[0] < 0)
        return 0;
    window_follow_ray(window); // the ray may have been selected in this iteration
    bool marched = window->inputs.pixel[0] >= 0 && window->ray.why[0] == '\0';
    return marched ? probe_rows(window->ray.probe) : 0;
}

static void show_steps(struct window *window, int shown, int steps)
{
    window->inputs.shown = fminf(fmaxf((float)shown, 1.0f), (float)steps);
    refresh(window);
}

void window_step(struct window *window, int by)
{
    const struct renderer_inputs *inputs = &window->inputs;
    const int middle[2] = {inputs->width / 2, inputs->height / 2};
    if (inputs->pixel[0] < 0 && window->renderer->fragment.marches)
        window_select_ray(window, middle);
    int steps = steps_of(window), shown = (int)inputs->shown;
    if (steps == 0)
        return;
    // While all steps are shown, stepping forwards shows the first step, and stepping backwards the
    // last.
    show_steps(window, shown == 0 && by < 0 ? steps : shown + by, steps);
}

bool window_step_to(struct window *window, bool last)
{
    int steps = steps_of(window);
    if (steps > 0)
        show_steps(window, last ? steps : 1, steps);
    return steps > 0;
}

bool window_table_covers(const struct window *window, const float unit[2])
{
    int step;
    return inspector_table_at(&window->panel.table, unit, &step);
}

void window_table_input(struct window *window, const struct window_event *event)
{
    int step, steps = steps_of(window);
    if (event->kind == EVENT_RELEASE && event->amount == 1 && steps > 0 &&
        inspector_table_at(&window->panel.table, event->unit, &step) && step >= 0)
        show_steps(window, step + 1, steps);
}

void window_follow_ray(struct window *window)
{
    const struct renderer_inputs *inputs = &window->inputs, shown = window_inputs_shown(window);
    const int *pixel = window->inputs.pixel;
    if (pixel[0] >= inputs->width || pixel[1] >= inputs->height || (pixel[0] >= 0 && pixel[1] < 0))
        window_deselect_ray(window);
    if (pixel[0] < 0 || window->ray.why[0] != '\0')
        return;
    if (renderer_at(window->renderer, inputs->width, inputs->pixel[0])->fragment.dialect !=
        DIALECT_COURSE) {
        snprintf(window->ray.why, sizeof window->ray.why,
                 "no march: rays are recorded from chapter 01 on, by shaders that use the course's "
                 "library");
    } else if (!renderer_probe(window->renderer, &shown, shown.pixel[0], shown.pixel[1],
                               window->ray.probe)) {
        snprintf(window->ray.why, sizeof window->ray.why, "%s", report_last());
    } else if (window->ray.print) {
        printf("ray of pixel %d,%d\n", pixel[0], pixel[1]);
        probe_print(window->ray.probe, stdout);
        fflush(stdout);
    }
    // The overlay marks the steps in a picture of the window's size.
    for (int k = 0; shown.width < inputs->width && k < probe_rows(window->ray.probe); k++)
        for (int i = 0; i < 2; i++)
            window->ray.probe->step[k].pixel[i] *= (float)inputs->width / (float)shown.width;
    window->ray.print = false;
}
