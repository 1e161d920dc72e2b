// A press is offered to the parts of the window in this order: an open colour picker, the panel,
// the table of a march, a handle, the divider of a comparison, a stroke of the chapter's tool, and
// the picture, where a drag looks around and a click selects a ray. The first part that claims the
// press owns the pointer until the release.
#include "window/pointer.h"

#include <math.h>
#include <string.h>

#include "picture/comparison.h"
#include "window/colour_picker.h"
#include "window/condition.h"
#include "window/field.h"
#include "window/handle.h"
#include "window/panel_input.h"
#include "window/ray.h"
#include "window/stroke.h"

#define DEGREES 0.15f // by which a movement of one window unit turns the camera
#define REACH   6.0   // distance in units of the overlay within which a press grabs the divider

void window_pointer_locate(const struct window *window, struct window_event *event)
{
    const struct renderer_inputs *inputs = &window->inputs;
    float scale = window->panel.overlay.scale;
    int width = 0, height = 0;
    glfwGetWindowSize(window->handle, &width, &height);
    event->unit[0] = event->unit[1] = -1.0f;
    if (width < 1 || height < 1)
        return;
    double down = event->position[1] * inputs->height / height;
    event->pixel[0] = event->position[0] * inputs->width / width;
    event->pixel[1] = inputs->height - down;
    if (scale <= 0.0f)
        return;
    event->unit[0] = (float)event->pixel[0] / scale;
    event->unit[1] = (float)down / scale;
}

// ---- The picture ----

// Moving the pointer to the right, dragging or captured, turns the view to the right.
static void look_around(struct window *window, const double movement[3])
{
    if (!window_reads(window, INPUT_MOUSE, INPUT_POINTER_SHARE))
        window_explain_key(window, KEY_WITH_CAMERA);
    if (!window_key_acts(window, KEY_WITH_CAMERA))
        return;
    camera_turn(&window->inputs.camera, DEGREES * (float)movement[0],
                -DEGREES * (float)movement[1]);
    window->moved = window->dirty = true;
}

// Handle the pointer on the picture while the button is down. The same events set Shadertoy's
// iMouse.
static void picture_input(struct window *window, const struct window_event *event)
{
    memcpy(window->pointer.last, event->pixel, sizeof event->pixel);
    if (event->kind == EVENT_PRESS || event->kind == EVENT_DOUBLE_PRESS) {
        window->pointer.pressed = true;
        memcpy(window->pointer.press, event->pixel, sizeof event->pixel);
    } else if (event->kind == EVENT_DRAG) {
        look_around(window, event->movement);
    } else if (event->kind == EVENT_RELEASE && event->amount == 1) {
        window_click_ray(window, window->pointer.press);
    }
}

// Update Shadertoy's iMouse for this frame: xy is the last position with the button down, zw that
// of the press; z is positive while the button is down, and w only in the frame of the press. If
// the shader reads iMouse, a change causes a frame to be drawn.
static void update_mouse(struct window *window)
{
    bool pressed = window->pointer.pressed, down = window->pointer.owner == OWNER_PICTURE;
    float *mouse = window->inputs.mouse;
    float now[4] = {mouse[0], mouse[1], fabsf(mouse[2]), fabsf(mouse[3])};
    for (int i = 0; i < 2; i++) {
        if (pressed || down)
            now[i] = (float)floor(window->pointer.last[i]);
        if (pressed)
            now[2 + i] = (float)floor(window->pointer.press[i]);
    }
    now[2] = down ? now[2] : -now[2];
    now[3] = pressed ? now[3] : -now[3];
    bool changed = false;
    for (int i = 0; i < 4; i++) {
        changed |= now[i] < mouse[i] || now[i] > mouse[i];
        mouse[i] = now[i];
    }
    window->pointer.pressed = false;
    window->stale |= changed && window_reads(window, INPUT_MOUSE, INPUT_POINTER_SHARE);
}

// ---- The divider of a comparison ----

static bool divider_covers(const struct window *window, const float unit[2])
{
    const struct comparison *comparison = window->renderer->comparison;
    double scale = (double)window->panel.overlay.scale;
    return comparison != NULL && unit[0] >= 0.0f &&
           fabs((double)unit[0] * scale - comparison->divider * window->inputs.width) <=
               REACH * scale;
}

static void divider_input(struct window *window, const struct window_event *event)
{
    if (event->kind != EVENT_DRAG)
        return;
    window->renderer->comparison->divider =
        fmin(fmax(event->pixel[0] / window->inputs.width, 0.0), 1.0);
    window->moved = window->dirty = window->ray.follow = true;
}

// ---- The owner ----

static enum pointer_owner claim(struct window *window, const struct window_event *press)
{
    if (window_picker_claims(window, press))
        return OWNER_PICKER;
    if (window_panel_covers(window, press->unit))
        return OWNER_PANEL;
    window_field_close(window);
    if (window_table_covers(window, press->unit))
        return OWNER_TABLE;
    if (press->amount != 0)
        return OWNER_NONE;
    if (window_handle_claims(window, press))
        return OWNER_HANDLE;
    if (divider_covers(window, press->unit))
        return OWNER_DIVIDER;
    return window_stroke_claims(window, press) ? OWNER_STROKE : OWNER_PICTURE;
}

// Set the pointer's shape to match what is under the pointer.
static void show_shape(struct window *window, const float unit[2])
{
    static const int shapes[SHAPES] = {0, GLFW_HAND_CURSOR, GLFW_HRESIZE_CURSOR,
                                       GLFW_CROSSHAIR_CURSOR};
    enum pointer_shape shape = SHAPE_ARROW;
    if (window_picker_covers(window, unit))
        shape = SHAPE_CROSSHAIR;
    else if (window_panel_covers(window, unit))
        shape = window_panel_shape(window, unit);
    else if (window_table_covers(window, unit) || window_handle_at(window, unit) >= 0)
        shape = SHAPE_HAND;
    else if (divider_covers(window, unit))
        shape = SHAPE_RESIZE;
    if (shape == window->shape)
        return;
    window->shape = shape;
    if (shape != SHAPE_ARROW && window->cursor[shape] == NULL)
        window->cursor[shape] = glfwCreateStandardCursor(shapes[shape]);
    glfwSetCursor(window->handle, window->cursor[shape]);
}

bool window_pointer_input(struct window *window, struct window_event *event)
{
    static void (*const input[])(struct window *, const struct window_event *) = {
        [OWNER_PICKER] = window_picker_input, [OWNER_PANEL] = window_panel_input,
        [OWNER_TABLE] = window_table_input,   [OWNER_HANDLE] = window_handle_input,
        [OWNER_DIVIDER] = divider_input,      [OWNER_STROKE] = window_stroke_input,
        [OWNER_PICTURE] = picture_input};
    if (event->kind < EVENT_PRESS || event->kind == EVENT_MOVE)
        return false;
    window_pointer_locate(window, event);
    if (event->kind == EVENT_WHEEL)
        return window_panel_wheel(window, event);
    if (event->kind == EVENT_LOOK) {
        look_around(window, event->movement);
        return true;
    }
    if (event->kind == EVENT_PRESS || event->kind == EVENT_DOUBLE_PRESS)
        window->pointer.owner = claim(window, event);
    if (window->pointer.owner != OWNER_NONE) {
        input[window->pointer.owner](window, event);
    } else if (event->kind == EVENT_HOVER) {
        window_panel_hover(window, event);
        show_shape(window, event->unit);
    }
    if (event->kind == EVENT_RELEASE)
        window->pointer.owner = OWNER_NONE;
    return true;
}

void window_pointer_rest(struct window *window)
{
    // The release may have been dropped if there were too many events.
    if (window->input.state == BUTTON_UP)
        window->pointer.owner = OWNER_NONE;
    window_stroke_rest(window);
    window_picker_update(window);
    window_panel_rest(window);
    update_mouse(window);
}
