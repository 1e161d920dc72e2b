#include "window/pages.h"

#include "picture/probe.h"
#include "window/condition.h"
#include "window/ray.h"

// True if Page Down or Page Up steps along the ray instead of changing the scene: the scene began
// at a step of the ray, and the next step is neither before that step nor after the ray's last.
static bool goes_on(const struct window *window, int by)
{
    int first = window->start->shown, to = (int)window->inputs.shown + by;
    return window->inputs.pixel[0] >= 0 && first > 0 && window->inputs.shown > 0.0f &&
           to >= first && to <= probe_rows(window->ray.probe);
}

void window_change_scene(struct window *window, int by)
{
    const struct contents *course = window->start->contents;
    int to = window->start->scene + by;
    if (window_has_scenes(window))
        window->asked.scenes = by;
    else
        window_note(window, "This window shows one chapter", "make run shows all of them");
    if (course != NULL && (to < 0 || to >= course->count))
        window_note(window, to < 0 ? "This is the first chapter" : "This is the last chapter",
                    "Home shows all chapters");
}

void window_turn_page(struct window *window, int by)
{
    if (!goes_on(window, by))
        window_change_scene(window, by);
}

void window_step_by_page(struct window *window, int by)
{
    if (goes_on(window, by))
        window_step(window, by);
}

void window_blacken(struct window *window)
{
    window->black = window_has_scenes(window);
}

bool window_ask_part(struct window *window, const struct window_event *event)
{
    int part = event->amount - GLFW_KEY_0;
    if (window->start->caption == NULL || !event->shifted || part < 1 || part > 9)
        return false;
    window->asked.part = part;
    return true;
}

bool window_ends_black(struct window *window, const struct window_event *event)
{
    int key = event->kind == EVENT_KEY ? event->amount : 0;
    bool pages = key == GLFW_KEY_PAGE_DOWN || key == GLFW_KEY_PAGE_UP || key == GLFW_KEY_N;
    if (!window->black || pages || (event->kind != EVENT_PRESS && event->kind != EVENT_KEY))
        return false;
    window->black = false;
    window->dirty = true;
    return true;
}
