// Where the pointer is on the overlay.
#include "window/state.h"

void window_overlay_place(const struct window *window, const double place[2], float at[2])
{
    const struct renderer_inputs *inputs = &window->inputs;
    float scale = window->panel.overlay.scale;
    int width = 0, height = 0;
    glfwGetWindowSize(window->handle, &width, &height);
    at[0] = at[1] = -1.0f;
    if (width < 1 || height < 1 || scale <= 0.0f)
        return;
    at[0] = (float)(place[0] * inputs->width / width) / scale;
    at[1] = (float)(place[1] * inputs->height / height) / scale;
}
