#include "window/actions.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "picture/comparison.h"
#include "picture/probe.h"
#include "picture/room.h"
#include "report.h"
#include "window/field.h"
#include "window/full_screen.h"
#include "window/handle.h"
#include "window/pointer.h"
#include "window/projection.h"
#include "window/ray.h"
#include "window/selection.h"
#include "window/stroke.h"

#define SPEED 2.0f // scene units per second

static void quit(struct window *window)
{
    glfwSetWindowShouldClose(window->handle, GLFW_TRUE);
}

static void shoot(struct window *window)
{
    window->shooting = true;
}

// Toggle the flag at an offset in the window.
static void toggle(struct window *window, int offset)
{
    bool *flag = (bool *)((char *)window + offset);
    *flag = !*flag;
}

static void restart(struct window *window, int camera)
{
    window->inputs.time = window->start->time;
    if (camera)
        window->inputs.camera = window->start->camera;
    window->stale = true;
}

static void select_next(struct window *window, int by)
{
    const struct renderer *renderer = window->renderer;
    const struct parameter *parameter = window_selected(window);
    int count = comparison_parameter_count(renderer), index = 0;
    if (parameter == NULL || window_nudge_handle(window, 0, -by))
        return;
    while (comparison_parameter(renderer, index) != parameter)
        index++;
    // The selection moves by one row even with Shift, because a jump of ten rows would be
    // confusing.
    window_select(window,
                  comparison_parameter(renderer, (index + (by > 0 ? 1 : count - 1)) % count));
}

static void change(struct window *window, int presses)
{
    struct parameter *parameter = window_selected(window);
    if (window_nudge_handle(window, presses, 0) || parameter == NULL)
        return;
    parameter_change(parameter, presses);
    window_parameter_changed(window);
}

static void reset(struct window *window)
{
    struct parameter *parameter = window_selected(window);
    if (parameter == NULL)
        return;
    parameter_reset(parameter);
    window_parameter_changed(window);
}

// Go to the first step of the selected ray. If there is none, reset the selected parameter.
static void go_first(struct window *window)
{
    if (!window_step_to(window, false))
        reset(window);
}

static void go_last(struct window *window)
{
    window_step_to(window, true);
}

// Hide or show the panel, and a lecture's caption with it.
static void hide(struct window *window)
{
    window->panel.folded = !window->panel.folded;
    window->panel.captioned = !window->panel.folded;
}

// True if Page Down or Page Up steps along the ray instead of changing the scene: the scene began
// at a step of the ray, and the next step is neither before that step nor after the ray's last.
static bool goes_on(const struct window *window, int by)
{
    int first = window->start->shown, to = (int)window->inputs.shown + by;
    return window->inputs.pixel[0] >= 0 && first > 0 && window->inputs.shown > 0.0f &&
           to >= first && to <= probe_rows(window->ray.probe);
}

// Ask for a lecture's next or previous scene. Holding the key does not repeat the request. Presses
// that pile up while a scene is compiled count once; otherwise an impatient speaker would skip
// scenes.
static void change_scene(struct window *window, int by)
{
    if (window->start->caption != NULL)
        window->asked.scenes = by;
}

static void turn_page(struct window *window, int by)
{
    if (!goes_on(window, by))
        change_scene(window, by);
}

static void step_by_page(struct window *window, int by)
{
    if (window->start->caption == NULL || goes_on(window, by))
        window_step(window, by);
}

#define FLAG(name)                                                                                 \
    .change = toggle, .amount = offsetof(struct window, name),                                     \
    .shifted = offsetof(struct window, name)

static const struct {
    void (*act)(struct window *window);                // called unless it is NULL
    void (*change)(struct window *window, int amount); // called if act is NULL
    int key;
    int amount, shifted; // the argument of change without and with Shift
    bool repeats;
} bindings[] = {
    {.key = GLFW_KEY_BACKSPACE, .act = quit},
    {.key = GLFW_KEY_P, .act = shoot},
    {.key = GLFW_KEY_F11, .act = window_toggle_full_screen},
    {.key = GLFW_KEY_TAB, .act = window_toggle_orthographic},
    {.key = GLFW_KEY_DELETE, .act = reset},
    {.key = GLFW_KEY_HOME, .act = go_first},
    {.key = GLFW_KEY_END, .act = go_last},
    {.key = GLFW_KEY_X, .act = window_deselect_ray},
    {.key = GLFW_KEY_ENTER, .act = window_next_handle},
    {.key = GLFW_KEY_ESCAPE, FLAG(paused)},
    {.key = GLFW_KEY_H, .act = hide},
    {.key = GLFW_KEY_K, FLAG(panel.helps)},
    {.key = GLFW_KEY_O, FLAG(panel.right)},
    {.key = GLFW_KEY_T, FLAG(panel.rolled)},
    {NULL, restart, GLFW_KEY_R, false, true, false},
    {NULL, window_take_back, GLFW_KEY_U, 1, INT_MAX, true},
    {NULL, select_next, GLFW_KEY_UP, -1, -10, true},
    {NULL, select_next, GLFW_KEY_DOWN, 1, 10, true},
    {NULL, change, GLFW_KEY_LEFT, -1, -10, true},
    {NULL, change, GLFW_KEY_RIGHT, 1, 10, true},
    {NULL, window_step, GLFW_KEY_E, 1, 1, true},
    {NULL, window_step, GLFW_KEY_Q, -1, -1, true},
    {NULL, change_scene, GLFW_KEY_N, 1, -1, false},
    // Page Down and Page Up are the keys of a presenter's remote control.
    {NULL, turn_page, GLFW_KEY_PAGE_DOWN, 1, 1, false},
    {NULL, turn_page, GLFW_KEY_PAGE_UP, -1, -1, false},
    {NULL, step_by_page, GLFW_KEY_PAGE_DOWN, 1, 1, true},
    {NULL, step_by_page, GLFW_KEY_PAGE_UP, -1, -1, true},
};

// In a lecture, Shift with a digit from 1 to 9 asks for a part. Returns true for such a key.
static bool ask_part(struct window *window, const struct window_event *event)
{
    int part = event->amount - GLFW_KEY_0;
    if (window->start->caption == NULL || !event->shifted || part < 1 || part > 9)
        return false;
    window->asked.part = part;
    return true;
}

static void press_key(struct window *window, const struct window_event *event)
{
    if (ask_part(window, event))
        return;
    bool pad = event->amount >= GLFW_KEY_KP_0 && event->amount <= GLFW_KEY_KP_9;
    int key = pad ? event->amount - GLFW_KEY_KP_0 + GLFW_KEY_0 : event->amount;
    if (key >= GLFW_KEY_1 && key < GLFW_KEY_1 + SHADER_VIEW_COUNT && !event->repeated) {
        window_show_view(window, key - GLFW_KEY_1);
        window->dirty = true;
        window->title.due = 0.0;
    }
    for (size_t i = 0; i < sizeof bindings / sizeof *bindings; i++)
        if (bindings[i].key == key && (bindings[i].repeats || !event->repeated)) {
            if (bindings[i].act != NULL)
                bindings[i].act(window);
            else
                bindings[i].change(window,
                                   event->shifted ? bindings[i].shifted : bindings[i].amount);
            window->dirty = true;
            window->title.due = 0.0;
        }
}

static void move(struct window *window, const double movement[3])
{
    float direction[3], longest = 0.0f;
    for (int axis = 0; axis < 3; axis++) {
        direction[axis] = (float)movement[axis];
        longest = fmaxf(longest, fabsf(direction[axis]));
    }
    struct camera moved = window->inputs.camera;
    camera_move(&moved, direction, SPEED * longest);
    // While an error is shown, the camera moves freely.
    if (window->panel.error[0] == '\0' &&
        !room_keep(window->renderer, &window->inputs, moved.position))
        snprintf(window->panel.error, sizeof window->panel.error, "%s", report_last());
    window->inputs.camera = moved;
}

static void act(struct window *window, struct window_event *event)
{
    if (event->kind == EVENT_KEY)
        press_key(window, event);
    else if (event->kind == EVENT_TYPED)
        window_field_type(window, event->amount);
    else if (!window_pointer_input(window, event)) {
        if (event->kind == EVENT_MOVE)
            move(window, event->movement);
        else
            window_zoom(window, event->movement[0]);
        window->moved = window->dirty = true;
        window->title.due = event->kind == EVENT_MOVE ? window->title.due : 0.0;
    }
}

// The events are handled in order, so a drag that follows Shift+R in the same iteration turns the
// camera that Shift+R has reset.
void window_act(struct window *window)
{
    struct window_input *input = &window->input;
    window_input_count(input);
    for (int i = 0; i < input->events; i++)
        act(window, &input->event[i]);
    window_pointer_rest(window);
    window->dirty |= input->damaged;
    window_input_forget(input);
}
