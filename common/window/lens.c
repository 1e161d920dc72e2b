#include "window/lens.h"

#include <math.h>

#include "picture/slice.h"

#define ZOOM          1.1 // factor of the focal length or the slice's zoom per wheel notch
#define FOCAL_MINIMUM 0.2 // if the shader declares no focalLength
#define FOCAL_MAXIMUM 10.0
#define TRANSITION    0.5 // seconds from one projection to the other

void window_zoom(struct window *window, double notches)
{
    struct renderer *renderer = window->renderer;
    struct parameter *parameter = parameters_find(&renderer->parameters, "focalLength");
    if (!shader_shows_ray(renderer->view) && window->unzoomed <= 0.0)
        window->unzoomed = parameter != NULL ? parameter->value[0] : (double)renderer->focal_length;
    double factor = pow(ZOOM, notches);
    if (shader_shows_ray(renderer->view))
        window->inputs.zoom =
            (float)fmin(fmax((double)window->inputs.zoom * factor, (double)SLICE_ZOOM_MINIMUM),
                        (double)SLICE_ZOOM_MAXIMUM);
    else if (parameter != NULL)
        parameter->value[0] =
            fmin(fmax(parameter->value[0] * factor, parameter->minimum), parameter->maximum);
    else
        renderer->focal_length = (float)fmin(
            fmax((double)renderer->focal_length * factor, FOCAL_MINIMUM), FOCAL_MAXIMUM);
}

void window_reset_zoom(struct window *window)
{
    struct renderer *renderer = window->renderer;
    struct parameter *parameter = parameters_find(&renderer->parameters, "focalLength");
    window->inputs.zoom = 1.0f;
    if (window->unzoomed > 0.0 && parameter != NULL)
        parameter->value[0] = fmin(fmax(window->unzoomed, parameter->minimum), parameter->maximum);
    else if (window->unzoomed > 0.0)
        renderer->focal_length = (float)window->unzoomed;
    window->unzoomed = 0.0;
}

// Return the value that Tab changes, or NULL if there is none. end receives the ends of the value's
// range.
static double *orthographic_of(struct window *window, double end[2])
{
    struct renderer *renderer = window->renderer;
    struct parameter *parameter = parameters_find(&renderer->parameters, "orthographic");
    end[0] = parameter != NULL ? parameter->minimum : 0.0;
    end[1] = parameter != NULL ? parameter->maximum : 1.0;
    if (parameter != NULL)
        return &parameter->value[0];
    bool read = inputs_reads(renderer->gl, renderer->program[renderer->view], &renderer->fragment,
                             INPUT_ORTHO, INPUT_ORTHO);
    return read ? &renderer->orthographic : NULL;
}

bool window_has_orthographic(struct window *window)
{
    double end[2];
    return orthographic_of(window, end) != NULL;
}

void window_toggle_orthographic(struct window *window)
{
    double end[2];
    const double *value = orthographic_of(window, end);
    if (value == NULL)
        return;
    double from = window->transition.on ? window->transition.target : *value;
    window->transition.target = from > 0.5 * (end[0] + end[1]) ? end[0] : end[1];
    window->transition.on = true;
}

bool window_continue_transition(struct window *window, double seconds)
{
    double end[2];
    double *value = window->transition.on ? orthographic_of(window, end) : NULL;
    window->transition.on = value != NULL;
    if (value == NULL)
        return false;
    // A bool or an int cannot change gradually.
    const struct parameter *parameter =
        parameters_find(&window->renderer->parameters, "orthographic");
    double left = window->transition.target - *value;
    double step = seconds / TRANSITION * (end[1] - end[0]);
    bool arrives = fabs(left) <= step || (parameter != NULL && parameter->type != PARAMETER_FLOAT);
    *value = arrives ? window->transition.target : *value + copysign(step, left);
    window->transition.on = !arrives;
    window->title.due = 0.0;
    return true;
}
