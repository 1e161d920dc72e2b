#include "window/actions.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>

#include "picture/comparison.h"
#include "picture/probe.h"
#include "picture/room.h"
#include "platform.h"
#include "report.h"
#include "window/contents.h"
#include "window/field.h"
#include "window/frames.h"
#include "window/full_screen.h"
#include "window/handle.h"
#include "window/keys.h"
#include "window/pointer.h"
#include "window/lens.h"
#include "window/pages.h"
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
    // A screenshot is the picture of a command.
    window->stale |= window->sharpening.inputs.samples != window->inputs.samples;
}

static void edit(struct window *window)
{
    const char *path = window->start->picture[0].path;
    if (window_key_acts(window, KEY_WITH_EDITOR) && !platform_edit(path)) {
        char note[sizeof window->panel.note];
        snprintf(note, sizeof note, "set VISUAL to the name of one, or open %s yourself", path);
        report("%s: no editor: set VISUAL to the name of one", path);
        window_note(window, "No editor", note);
    }
}

static void show_keys(struct window *window)
{
    window->panel.helps = !window->panel.helps;
}

static void change_side(struct window *window)
{
    window->panel.right = !window->panel.right;
    window->panel.room = ROOM_DECIDED;
}

static void roll(struct window *window)
{
    window->panel.rolled = !window->panel.rolled;
    window->panel.room = ROOM_DECIDED;
}

static void restart(struct window *window, int camera)
{
    if (!camera && !window_uses_time(window))
        window_note(window, "Nothing to restart",
                    window_key_acts(window, KEY_WITH_CAMERA)
                        ? "this picture does not change with time; Shift+R resets the camera"
                        : "this picture does not change with time");
    window->inputs.begin = window->inputs.time = window->start->time;
    window->inputs.frame = window_keeps(window) ? 0 : window->inputs.frame;
    if (camera) {
        window->inputs.camera = window->start->camera;
        window_reset_zoom(window);
    }
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
    // confusing. The components of a vector are rows below the vector's own.
    int part = window_selected_part(window) + (by > 0 ? 1 : -1);
    int parts = parameter->components > 1 ? parameter->components : 0;
    if (part < -1 || part >= parts) {
        parameter = comparison_parameter(renderer, (index + (by > 0 ? 1 : count - 1)) % count);
        part = by < 0 && parameter->components > 1 ? parameter->components - 1 : -1;
    }
    window_select(window, parameter, part);
}

static void change(struct window *window, int presses)
{
    struct parameter *parameter = window_selected(window);
    if (window_nudge_handle(window, presses, 0) || parameter == NULL)
        return;
    struct parameter next = *parameter;
    parameter_change(&next, presses);
    window_copy_parts(parameter, next.value, window_selected_part(window));
    window_parameter_changed(window);
}

static void reset(struct window *window)
{
    struct parameter *parameter = window_selected(window);
    if (parameter == NULL)
        return;
    window_copy_parts(parameter, parameter->initial, window_selected_part(window));
    window_parameter_changed(window);
}

// Go to the first step of the selected ray. If there is none, or if the course's ray is there, show
// the contents or, outside a course, reset the selected parameter.
static void go_first(struct window *window)
{
    bool there = window->inputs.pixel[0] >= 0 && window->inputs.shown == 1.0f;
    bool course = window_has_contents(window);
    bool stepped = !(there && course) && window_step_to(window, false);
    if (stepped && course)
        window_note(window, "The first step of the ray", "Home again: all chapters");
    else if (stepped)
        return;
    else if (course)
        window_toggle_contents(window);
    else
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

static const char captured[] = "The mouse is captured";

// A captured mouse is released by the input itself.
static void capture(struct window *window)
{
    if (!window_key_acts(window, KEY_WITH_CAMERA))
        return;
    window_input_capture(&window->input);
    window_note(window, captured, "M or Escape releases it");
}

// Show only the left picture of a comparison, or only the right one if the left one is alone.
static void show_side(struct window *window, int both)
{
    struct comparison *comparison = window->renderer->comparison;
    if (comparison == NULL)
        return;
    comparison->divider = both ? 0.5 : comparison->divider >= 1.0 ? 0.0 : 1.0;
    window->moved = window->ray.follow = true;
}

// The order is that of the overlay's list. Page Down and Page Up are the keys of a presenter's
// remote control.
#define VIEW_KEY(id, kind, key, name)  " " #key
#define VIEW_WORD(id, kind, key, name) " " #key " " name
// clang-format off
const struct key_row window_keys[] = {
    {.label = "Page Up Page Down", .does = "chapter or scene", .condition = KEY_WITH_SCENES,
     .meaning = "in the course or in a lecture, go to the chapter or the scene before or to the next one; if "
                "a scene began with the steps of a ray, first to its next step",
     .binding = {{GLFW_KEY_PAGE_DOWN, .change = window_turn_page, .amount = 1, .shifted = 1},
                 {GLFW_KEY_PAGE_UP, .change = window_turn_page, .amount = -1, .shifted = -1},
                 {GLFW_KEY_PAGE_DOWN, .change = window_step_by_page, .amount = 1, .shifted = 1, .repeats = true},
                 {GLFW_KEY_PAGE_UP, .change = window_step_by_page, .amount = -1, .shifted = -1, .repeats = true}}},
    {.label = "N", .does = "next scene", .condition = KEY_IN_LECTURE,
     .meaning = "in a lecture, and in the list of a class's wrong pictures, go to the next scene without "
                "the steps of a ray; with Shift, go back",
     .binding = {{GLFW_KEY_N, .change = window_change_scene, .amount = 1, .shifted = -1}}},
    {.label = "Home", .does = "contents", .condition = KEY_WITH_CONTENTS,
     .meaning = "in the course, show all chapters; while a ray is selected, a second press is needed",
     .binding = {{0}}}, // go_first
    {.label = "Shift+1…9", .does = "part", .condition = KEY_IN_LECTURE,
     .meaning = "in a lecture, go to a part",
     .binding = {{0}}}, // window_ask_part
    {.label = "B .", .does = "black screen", .condition = KEY_WITH_SCENES,
     .meaning = "in the course or in a lecture, make the screen black; a key, a click or another scene ends this",
     .binding = {{GLFW_KEY_B, .act = window_blacken}, {GLFW_KEY_PERIOD, .act = window_blacken}}},
    {.label = "W A S D", .does = "move", .condition = KEY_WITH_CAMERA,
     .meaning = "move horizontally. In most chapters from 03 on, the camera stops at the ground and at the "
                "water"},
    {.label = "Space C", .does = "up, down", .condition = KEY_WITH_CAMERA,
     .meaning = "move up or down; Left Ctrl is the same as C"},
    {.label = "Shift F", .does = "faster", .condition = KEY_WITH_CAMERA,
     .meaning = "hold one of them to move faster"},
    {.label = "drag", .does = "look around", .condition = KEY_WITH_CAMERA,
     .meaning = "look around, or move the divider of --compare"},
    {.label = "L", .does = "left, right", .condition = KEY_WITH_COMPARISON,
     .meaning = "with --compare, show only the left picture, and then only the right one, so that whatever "
                "differs seems to move; with Shift, show half of each",
     .binding = {{GLFW_KEY_L, .change = show_side, .amount = false, .shifted = true}}},
    {.label = "M", .does = "capture mouse", .condition = KEY_WITH_CAMERA,
     .meaning = "capture the mouse, so that you can look around without holding a button; M or Escape releases it",
     .binding = {{GLFW_KEY_M, .act = capture}}},
    {.label = "click", .does = "select ray", .condition = KEY_WITH_MARCH,
     .meaning = "select a pixel and show the march of its ray step by step; on a line of that table, go to "
                "the step. A second click on the same pixel deselects it. When the camera moves, the ray "
                "stays where it is in space"},
    {.label = "Q E", .does = "step back, on", .condition = KEY_WITH_MARCH,
     .meaning = "go one step back or forward along the ray; hold to repeat. If no ray is selected, they "
                "select the ray of the middle pixel",
     .binding = {{GLFW_KEY_E, .change = window_step, .amount = 1, .shifted = 1, .repeats = true},
                 {GLFW_KEY_Q, .change = window_step, .amount = -1, .shifted = -1, .repeats = true}}},
    {.label = "Home End", .does = "first, last step", .condition = KEY_WITH_RAY,
     .meaning = "go to the ray's first or last step. If no ray is selected, Home resets the parameter",
     .binding = {{GLFW_KEY_HOME, .act = go_first}, {GLFW_KEY_END, .act = go_last}}},
    {.label = "X", .does = "deselect ray", .condition = KEY_WITH_RAY, .meaning = "deselect the ray",
     .binding = {{GLFW_KEY_X, .act = window_deselect_ray}}},
    {.label = "wheel", .does = "zoom", .condition = KEY_WITH_LENS,
     .meaning = "change the focal length; in the slice and the plot, zoom"},
    {.label = &(SHADER_VIEWS(VIEW_KEY))[1], .does = "view", .condition = KEY_WITH_MARCH,
     .meaning = "switch to another view, also on the number pad:" SHADER_VIEWS(VIEW_WORD),
     .binding = {{GLFW_KEY_1, .change = window_show_view, .count = SHADER_VIEW_COUNT}}},
    {.label = "↑ ↓", .does = "select", .condition = KEY_WITH_PARAMETERS,
     .meaning = "select a parameter or one component of a vector; the overlay and the title bar show it",
     .binding = {{GLFW_KEY_UP, .change = select_next, .amount = -1, .shifted = -10, .repeats = true},
                 {GLFW_KEY_DOWN, .change = select_next, .amount = 1, .shifted = 10, .repeats = true}}},
    {.label = "← →", .does = "change", .condition = KEY_WITH_PARAMETERS,
     .meaning = "change the selected parameter; with Shift, by ten steps",
     .binding = {{GLFW_KEY_LEFT, .change = change, .amount = -1, .shifted = -10, .repeats = true},
                 {GLFW_KEY_RIGHT, .change = change, .amount = 1, .shifted = 10, .repeats = true}}},
    {.label = "Delete", .does = "reset", .condition = KEY_WITH_PARAMETERS,
     .meaning = "reset the selected parameter",
     .binding = {{GLFW_KEY_DELETE, .act = reset}}},
    {.label = "Enter", .does = "next handle", .condition = KEY_WITH_HANDLES,
     .meaning = "focus the next handle, a point of the picture that you can drag; the arrow keys then move it",
     .binding = {{GLFW_KEY_ENTER, .act = window_next_handle}}},
    {.label = "U Shift+U", .does = "undo stroke, all", .condition = KEY_WITH_TOOL,
     .meaning = "with the tool of chapter 23, whose drags change the clay, take back the last stroke or all "
                "of them",
     .binding = {{GLFW_KEY_U, .change = window_take_back, .amount = 1, .shifted = INT_MAX, .repeats = true}}},
    {.label = "Tab", .does = "orthographic", .condition = KEY_WITH_PROJECTIONS,
     .meaning = "switch between the perspective and the orthographic view, if the shader has both",
     .binding = {{GLFW_KEY_TAB, .act = window_toggle_orthographic}}},
    {.label = "Esc", .does = "pause", .condition = KEY_WITH_TIME,
     .meaning = "pause or resume",
     .binding = {{GLFW_KEY_ESCAPE, .act = window_pause}}},
    {.label = "R Shift+R", .does = "restart, with camera", .meaning = "restart the time; with Shift, also reset the camera and the zoom",
     .binding = {{GLFW_KEY_R, .change = restart, .amount = false, .shifted = true}}},
    {.label = "P", .does = "screenshot", .meaning = "save a screenshot in the current folder",
     .binding = {{GLFW_KEY_P, .act = shoot}}},
    {.label = "V", .does = "edit", .condition = KEY_WITH_EDITOR,
     .meaning = "open the shader in your editor, $VISUAL or $EDITOR; each save is shown at once. A file that "
                "is dropped on the window is opened: another shader, or a picture for this one",
     .binding = {{GLFW_KEY_V, .act = edit}}},
    {.label = "H", .does = "hide overlay",
     .meaning = "hide or show the overlay; the table of a ray is hidden only in the slice and the plot",
     .binding = {{GLFW_KEY_H, .act = hide}}},
    {.label = "K", .does = "fewer keys", .meaning = "show all keys and ranges in the overlay, or fewer",
     .binding = {{GLFW_KEY_K, .act = show_keys}}},
    {.label = "O", .does = "panel right, left", .meaning = "move the panel of parameters to the other side",
     .binding = {{GLFW_KEY_O, .act = change_side}}},
    {.label = "T", .does = "collapse panel", .meaning = "collapse the panel to its title, or expand it",
     .binding = {{GLFW_KEY_T, .act = roll}}},
    {.label = "F11", .does = "full screen", .meaning = "switch to full screen, or back",
     .binding = {{GLFW_KEY_F11, .act = window_toggle_full_screen}}},
    {.label = "Backspace", .does = "quit", .meaning = "quit",
     .binding = {{GLFW_KEY_BACKSPACE, .act = quit}}},
    {0}
};
// clang-format on
// A press counts the views from key 1 on, whatever their rows say.
#define VIEW_IN_PLACE(id, kind, key, name)                                                         \
    _Static_assert((key) == VIEW_##id + 1 && (key) <= 9, "the key of a view is its place");
SHADER_VIEWS(VIEW_IN_PLACE)
_Static_assert(sizeof window_keys / sizeof *window_keys - 1 <= WINDOW_KEYS,
               "WINDOW_KEYS of state.h is too small");

static void press_key(struct window *window, const struct window_event *event)
{
    if (window_ask_part(window, event))
        return;
    window->panel.note[0] = '\0';
    bool pad = event->amount >= GLFW_KEY_KP_0 && event->amount <= GLFW_KEY_KP_9;
    int key = pad ? event->amount - GLFW_KEY_KP_0 + GLFW_KEY_0 : event->amount;
    for (const struct key_row *row = window_keys; row->label != NULL; row++)
        for (const struct key_binding *at = row->binding; at < row->binding + KEY_BINDINGS; at++) {
            int index = key - at->key;
            if (at->key == 0 || index < 0 || index > at->count - (at->count > 0) ||
                (event->repeated && !at->repeats))
                continue;
            window_explain_key(window, row->condition);
            if (row->condition == KEY_WITH_MARCH && !window_key_acts(window, row->condition))
                continue;
            if (at->act != NULL)
                at->act(window);
            else
                at->change(window, (event->shifted ? at->shifted : at->amount) + index);
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
    if (window_ends_black(window, event) || window_contents_input(window, event))
        return;
    window->input.armed &= event->kind != EVENT_KEY && event->kind != EVENT_MOVE;
    if (event->kind == EVENT_KEY)
        press_key(window, event);
    else if (event->kind == EVENT_TYPED)
        window_field_type(window, event->amount);
    else if (!window_pointer_input(window, event)) {
        window_explain_key(window, event->kind == EVENT_MOVE ? KEY_WITH_CAMERA : KEY_WITH_LENS);
        if (event->kind == EVENT_MOVE && window_key_acts(window, KEY_WITH_CAMERA))
            move(window, event->movement);
        else if (event->kind == EVENT_WHEEL)
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
    if (window->panel.note_heading == captured && !input->captured)
        window->panel.note[0] = '\0';
    window_pointer_rest(window);
    window->dirty |= input->damaged;
    window_input_forget(input);
}
