// The ray that a click chooses.
#include <math.h>

#include "window/state.h"

// A click also drives a parameter of two numbers named aim, if the shader has one: it becomes the
// place of the plane z = 0 that the pixel shows, as far as its range goes.
static void take_aim(struct window *window, const int pixel[2])
{
    const struct renderer_inputs *inputs = &window->inputs;
    struct parameters *all = &window->renderer->parameters;
    struct parameter *aim = parameters_find(all, "aim");
    const struct parameter *focal = parameters_find(all, "focalLength");
    if (aim == NULL || aim->components != 2)
        return;
    struct camera_basis basis = camera_basis_of(&inputs->camera);
    double length = focal != NULL ? focal->value[0] : (double)window->renderer->focal_length,
           way[3];
    double x = (2.0 * pixel[0] + 1.0 - inputs->width) / inputs->height;
    double y = (2.0 * pixel[1] + 1.0 - inputs->height) / inputs->height;
    for (int i = 0; i < 3; i++)
        way[i] = x * (double)basis.right[i] + y * (double)basis.up[i] +
                 length * (double)basis.forward[i];
    double t = -(double)inputs->camera.position[2] / way[2];
    if (!(t > 0.0 && t < 1e6)) // the plane is behind the eye, or nowhere in this direction
        return;
    for (int i = 0; i < 2; i++)
        aim->value[i] =
            fmin(fmax((double)inputs->camera.position[i] + t * way[i], aim->minimum), aim->maximum);
    window->stale = true;
}

void window_look_at_ray(struct window *window, const double place[2])
{
    const int *pixel = window->inputs.pixel;
    int size[2] = {0, 0}, at[2];
    glfwGetWindowSize(window->handle, &size[0], &size[1]);
    if (size[0] < 1 || size[1] < 1)
        return;
    renderer_pixel_at(&window->inputs, place, size, at);
    take_aim(window, at);
    if (at[0] == pixel[0] && at[1] == pixel[1])
        window_leave_ray(window);
    else
        window_choose_ray(window, at);
}
