// Who has the pointer. The first that claims a press keeps it until the release, in this order: the
// panel, the divider between two pictures, then the picture, where a drag looks around and a click
// chooses a ray.
#include <string.h>

#include "window/state.h"

#define DEGREES 0.15f // of a turn, for each pixel of the pointer

static enum window_hand claim(struct window *window, const struct window_event *press)
{
    // What closes a picker does nothing else.
    if (window_touch_claims(window, press->place) || window->input.picking)
        return HAND_PANEL;
    window_field_leave(window);
    if (press->amount != 0)
        return HAND_NONE;
    return window_at_divider(window, press->place) ? HAND_DIVIDER : HAND_CAMERA;
}

// A pointer that goes right turns the view right, dragging or captured.
static void look_around(struct window *window, const double way[3])
{
    camera_turn(&window->inputs.camera, DEGREES * (float)way[0], -DEGREES * (float)way[1]);
    window->moved = window->dirty = true;
}

// The pointer over the picture with its button down: Shadertoy's mouse follows it.
static void hold_picture(struct window *window, const struct window_event *event)
{
    memcpy(window->hand.at, event->place, sizeof window->hand.at);
    if (event->action == WINDOW_PRESS || event->action == WINDOW_DOUBLE) {
        window->hand.pressed = true;
        memcpy(window->hand.press, event->place, sizeof window->hand.press);
    } else if (event->action == WINDOW_DRAG) {
        look_around(window, event->way);
    } else if (event->action == WINDOW_RELEASE && event->amount == 1) {
        window_look_at_ray(window, window->hand.press);
        window->dirty = true;
        window->title.due = 0.0;
    }
}

bool window_hand(struct window *window, const struct window_event *event)
{
    if (event->action == WINDOW_LOOK) // a captured pointer reaches nothing but the camera
        look_around(window, event->way);
    else if (event->action == WINDOW_PRESS || event->action == WINDOW_DOUBLE)
        window->hand.who = claim(window, event);
    bool pointer = event->action == WINDOW_PRESS || event->action == WINDOW_DOUBLE ||
                   event->action == WINDOW_DRAG || event->action == WINDOW_POINT ||
                   event->action == WINDOW_RELEASE;
    if (pointer && window->hand.who == HAND_CAMERA)
        hold_picture(window, event);
    else if (event->action == WINDOW_DRAG && window->hand.who == HAND_DIVIDER)
        window_drag_divider(window, event->place);
    else if (pointer && window->hand.who == HAND_PANEL)
        window_touch(window, event);
    else if (event->action == WINDOW_POINT)
        window_touch_point(window, event);
    if (event->action == WINDOW_RELEASE)
        window->hand.who = HAND_NONE;
    if (event->action == WINDOW_ZOOM)
        return window_touch_wheel(window, event);
    return pointer || event->action == WINDOW_LOOK;
}

// Of too many events in one turn the last are lost, a release too.
void window_let_go(struct window *window)
{
    if (window->input.state == WINDOW_POINTER_FREE)
        window->hand.who = HAND_NONE;
}
