// What Shadertoy's inputs tell of the window: the mouse and the date.
#include "window/state.h"

#include <math.h>

#include "platform.h"

// A place of the pointer, from the top left of the window, in pixels of the picture from its bottom
// left, as Shadertoy rounds it.
static void pixel_of(const struct window *window, const double place[2], float pixel[2])
{
    const struct renderer_inputs *inputs = &window->inputs;
    int width = 0, height = 0;
    glfwGetWindowSize(window->handle, &width, &height);
    if (width < 1 || height < 1)
        return;
    pixel[0] = (float)floor(place[0] * inputs->width / width);
    pixel[1] = (float)floor(inputs->height - place[1] * inputs->height / height);
}

void window_follow_mouse(struct window *window)
{
    const struct renderer *renderer = window->renderer;
    bool pressed = window->hand.pressed, down = window->hand.who == HAND_CAMERA;
    float *mouse = window->inputs.mouse;
    float now[4] = {mouse[0], mouse[1], fabsf(mouse[2]), fabsf(mouse[3])};
    if (pressed)
        pixel_of(window, window->hand.press, now + 2);
    if (pressed || down)
        pixel_of(window, window->hand.at, now);
    now[2] = down ? now[2] : -now[2];
    now[3] = pressed ? now[3] : -now[3];
    bool changed = false;
    for (int i = 0; i < 4; i++) {
        changed |= now[i] < mouse[i] || now[i] > mouse[i];
        mouse[i] = now[i];
    }
    GLuint program = renderer->program[renderer->view];
    if (changed && renderer->gl->GetUniformLocation(program, "iMouse") >= 0)
        window->stale = true;
}

void window_tell_date(struct window *window)
{
    struct tm day = {0};
    double fraction = platform_date(&day);
    float *date = window->inputs.date;
    date[0] = (float)(day.tm_year + 1900);
    date[1] = (float)day.tm_mon;
    date[2] = (float)day.tm_mday;
    date[3] = (float)(3600 * day.tm_hour + 60 * day.tm_min + day.tm_sec) + (float)fraction;
}
