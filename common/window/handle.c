#include "window/handle.h"

#include <math.h>

#include "picture/pen.h"
#include "window/selection.h"

#define REACH 14.0 // distance in units of the overlay within which a press grabs a handle
#define NUDGE 0.01 // movement of a handle per key press, as a fraction of the picture's height

static bool are_shown(const struct window *window)
{
    bool hidden = window->panel.folded && !window->panel.in_page;
    return !hidden && !shader_shows_ray(window->renderer->view);
}

// Find the position of a handle, in units of the overlay. Returns false if the handle cannot be
// seen.
static bool locate(const struct window *window, const struct handle *handle, float unit[2])
{
    float scale = window->panel.overlay.scale;
    unit[0] = handle->pixel[0] / scale;
    unit[1] = ((float)window->inputs.height - handle->pixel[1]) / scale;
    return handle->seen && are_shown(window) &&
           !panel_rows_hold(&window->panel.rows, unit[0], unit[1]);
}

int window_handle_at(const struct window *window, const float unit[2])
{
    double nearest = REACH;
    float at[2];
    int found = -1;
    for (int i = 0; i < window->handles.count; i++) {
        if (!locate(window, &window->handles.item[i], at))
            continue;
        double distance = hypot((double)(at[0] - unit[0]), (double)(at[1] - unit[1]));
        if (distance > nearest)
            continue;
        nearest = distance;
        found = i;
    }
    return found;
}

static void focus(struct window *window, int handle)
{
    window->dirty |= handle != window->handles.focused;
    window->handles.focused = handle;
    if (handle >= 0)
        window_select(window, window->handles.item[handle].parameter, -1);
}

bool window_handle_claims(struct window *window, const struct window_event *press)
{
    int handle = window_handle_at(window, press->unit);
    focus(window, handle);
    for (int i = 0; i < 2 && handle >= 0; i++)
        window->handles.offset[i] = (double)window->handles.item[handle].pixel[i] - press->pixel[i];
    return handle >= 0;
}

void window_handle_input(struct window *window, const struct window_event *event)
{
    if (event->kind != EVENT_DRAG)
        return;
    for (int i = 0; i < 2; i++)
        window->handles.target[i] = event->pixel[i] + window->handles.offset[i];
    window->handles.moving = true;
}

void window_next_handle(struct window *window)
{
    int next = window->handles.focused + 1;
    focus(window, next < window->handles.count && are_shown(window) ? next : -1);
}

bool window_nudge_handle(struct window *window, int right, int up)
{
    if (window->handles.focused < 0 || !are_shown(window))
        return false;
    const struct handle *handle = &window->handles.item[window->handles.focused];
    const int direction[2] = {right, up};
    for (int i = 0; i < 2; i++)
        window->handles.target[i] =
            (double)handle->pixel[i] + NUDGE * window->inputs.height * direction[i];
    window->handles.moving = true;
    return true;
}

bool window_place_handles(struct window *window)
{
    struct handle *item = window->handles.item;
    bool shown = are_shown(window);
    int count = shown ? handles_find(window->renderer, &window->inputs, item) : 0;
    window->handles.count = count;
    if (shown && window->handles.focused >= count)
        window->handles.focused = -1;
    // A handle that left the picture could not be grabbed again.
    const double side[2] = {window->inputs.width, window->inputs.height};
    for (int i = 0; i < 2; i++)
        window->handles.target[i] = fmin(fmax(window->handles.target[i], 0.0), side[i]);
    if (window->handles.moving && count > 0 && window->handles.focused >= 0 &&
        handles_drag(window->renderer, &window->inputs, item, window->handles.focused,
                     window->handles.target))
        window_parameter_changed(window);
    window->handles.moving = false;
    return count >= 0;
}

// True if the panel is drawn above a handle that would be shown without it.
static bool is_covering(const struct window *window)
{
    float scale = window->panel.overlay.scale;
    for (int i = 0; i < window->handles.count && are_shown(window); i++) {
        const struct handle *handle = &window->handles.item[i];
        if (handle->seen &&
            panel_rows_hold(&window->panel.rows, handle->pixel[0] / scale,
                            ((float)window->inputs.height - handle->pixel[1]) / scale))
            return true;
    }
    return false;
}

bool window_uncover_handles(struct window *window, int moves)
{
    enum panel_room *room = &window->panel.room;
    bool flat = shader_includes(&window->renderer->fragment, "shaders/figure.glsl");
    if ((moves == 0 && *room != ROOM_UNKNOWN) || *room >= ROOM_COLLAPSED ||
        (window->handles.count == 0 && !flat) || window->panel.in_page)
        return false;
    if (!is_covering(window) && !(flat && moves == 0 && !window->panel.right)) {
        *room = moves == 0 ? ROOM_DECIDED : *room;
        return false;
    }
    *room = moves == 0 && !window->panel.right ? ROOM_MOVED : ROOM_COLLAPSED;
    window->panel.right = true;
    window->panel.rolled |= *room == ROOM_COLLAPSED;
    return true;
}

void window_draw_handles(struct window *window)
{
    static const struct overlay_colour core = {{36, 110, 214, 255}};
    struct overlay *overlay = &window->panel.overlay;
    float at[2];
    for (int i = 0; i < window->handles.count; i++) {
        if (!locate(window, &window->handles.item[i], at))
            continue;
        bool focused = i == window->handles.focused;
        float more = focused ? 3.0f : 0.0f;
        overlay_line(overlay, at, at, 14.0f + more, PEN_DARK);
        overlay_line(overlay, at, at, 12.0f + more, PEN_BRIGHT);
        overlay_line(overlay, at, at, 7.0f + more, focused ? PEN_HERE : core);
    }
}
