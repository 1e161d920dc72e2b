#include "window/state.h"

#include <math.h>
#include <stdio.h>

#include "picture/pair.h"
#include "picture/aside.h"
#include "report.h"

// What the ray and its march show is drawn again: in slice and plot that is the picture.
static void look_again(struct window *window)
{
    window->ray.follow = window->dirty = true;
    window->stale |= form_shows_ray(window->renderer->view);
}

void window_choose_ray(struct window *window, const int pixel[2])
{
    const struct renderer_inputs *inputs = &window->inputs;
    const int size[2] = {inputs->width, inputs->height};
    for (int i = 0; i < 2; i++) {
        window->inputs.pixel[i] = pixel[i];
        window->ray.place[i] = (2.0 * pixel[i] + 1.0 - size[i]) / inputs->height;
    }
    window->ray.eye = aside_eye(window->renderer, &window->inputs);
    window->inputs.eye = &window->ray.eye;
    window->inputs.shown = 0.0f;
    window->ray.why[0] = '\0';
    window->ray.tell = true;
    look_again(window);
}

void window_leave_ray(struct window *window)
{
    window->inputs.pixel[0] = window->inputs.pixel[1] = -1;
    window->inputs.eye = NULL;
    window->inputs.shown = 0.0f;
    window->ray.why[0] = '\0';
    window->ray.tell = false;
    look_again(window);
}

void window_resize_ray(struct window *window, int width, int height)
{
    int *pixel = window->inputs.pixel;
    if (pixel[0] < 0)
        return;
    const double *place = window->ray.place;
    pixel[0] = (int)floor(0.5 * (place[0] * height + width));
    pixel[1] = (int)floor(0.5 * (place[1] * height + height));
    if (pixel[0] < 0 || pixel[0] >= width)
        window_leave_ray(window);
    else
        look_again(window);
}

// How many steps the march has that is looked at; 0: there is none.
static int steps_of(struct window *window)
{
    if (window->inputs.pixel[0] < 0)
        return 0;
    window_follow_ray(window); // it may have been chosen in this turn
    return window->inputs.pixel[0] >= 0 && window->ray.why[0] == '\0'
               ? probe_rows(window->ray.probe)
               : 0;
}

static void show_steps(struct window *window, int shown, int steps)
{
    window->inputs.shown = fminf(fmaxf((float)shown, 1.0f), (float)steps);
    look_again(window);
}

void window_step(struct window *window, int by)
{
    const struct renderer_inputs *inputs = &window->inputs;
    const int middle[2] = {inputs->width / 2, inputs->height / 2};
    if (inputs->pixel[0] < 0 && window->renderer->fragment.form == SHADER_COURSE)
        window_choose_ray(window, middle);
    int steps = steps_of(window), shown = (int)inputs->shown;
    if (steps == 0)
        return;
    // Where all of them are shown the way on begins at the first, and the way back at the last.
    show_steps(window, shown == 0 && by < 0 ? steps : shown + by, steps);
}

bool window_step_to(struct window *window, bool last)
{
    int steps = steps_of(window);
    if (steps > 0)
        show_steps(window, last ? steps : 1, steps);
    return steps > 0;
}

void window_follow_ray(struct window *window)
{
    const struct renderer_inputs *inputs = &window->inputs;
    const int *pixel = window->inputs.pixel;
    if (pixel[0] >= inputs->width || pixel[1] >= inputs->height || (pixel[0] >= 0 && pixel[1] < 0))
        window_leave_ray(window);
    if (pixel[0] < 0 || window->ray.why[0] != '\0')
        return;
    if (pair_at(window->renderer, inputs->width, inputs->pixel[0])->fragment.form !=
        SHADER_COURSE) {
        snprintf(window->ray.why, sizeof window->ray.why,
                 "no march: a file with a main of its own keeps no trace of its rays");
    } else if (!renderer_probe(window->renderer, inputs, pixel[0], pixel[1], window->ray.probe)) {
        snprintf(window->ray.why, sizeof window->ray.why, "%s", report_last());
    } else if (window->ray.tell) {
        printf("ray of pixel %d,%d\n", pixel[0], pixel[1]);
        probe_print(window->ray.probe, stdout);
        fflush(stdout);
    }
    window->ray.tell = false;
}
