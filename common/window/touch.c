// The pointer on the panel: values are dragged, switched, typed, reset; the panel is moved and
// folded.
#include "window/state.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/pair.h"

#define TIP_SECONDS 0.5 // the pointer rests before help appears
#define FINE        0.1 // of a drag's way, while Left Shift is held

// ---- Where the pointer is ----

// None below an open picker.
static const struct panel_row *row_at(const struct window *window, const double place[2])
{
    float at[2];
    window_overlay_place(window, place, at);
    if (window_pick_at(window, place))
        return NULL;
    return panel_rows_at(&window->panel.rows, at[0], at[1]);
}

bool window_touch_claims(const struct window *window, const double place[2])
{
    float at[2];
    window_overlay_place(window, place, at);
    return window_pick_at(window, place) || panel_rows_hold(&window->panel.rows, at[0], at[1]);
}

static struct parameter *parameter_of(const struct window *window, const struct panel_row *row)
{
    bool there = row != NULL && row->parameter >= 0;
    return there ? pair_parameter(window->renderer, row->parameter) : NULL;
}

static bool is_switch(const struct parameter *parameter)
{
    return parameter->type == PARAMETER_BOOL ||
           (parameter->type == PARAMETER_INT && parameter->maximum - parameter->minimum <= 1.0);
}

// ---- What is changed ----

static void press(struct window *window, const struct window_event *event)
{
    const struct panel_row *row = row_at(window, event->place);
    const struct parameter *parameter = parameter_of(window, row);
    float at[2];
    window_overlay_place(window, event->place, at);
    window->touch.what = TOUCH_NOTHING;
    if (row != NULL && row->kind == PANEL_ROW_TITLE)
        window->touch.what = panel_row_is_mark(row, at[0]) ? TOUCH_MARK : TOUCH_TITLE;
    if (parameter == NULL)
        return;
    window->touch.what = is_switch(parameter) ? TOUCH_SWITCH : TOUCH_VALUE;
    if (panel_row_is_swatch(row, at[0]))
        window->touch.what = TOUCH_SWATCH;
    window->touch.part = row->part;
    window_choose(window, parameter);
    for (int k = 0; k < parameter->components; k++)
        window->touch.place[k] = parameter_place(parameter, k);
    window->touch.width = row->width;
    window->title.due = 0.0;
}

static void reset(struct window *window)
{
    int first, behind;
    struct parameter *parameter = window_taken(window, &first, &behind);
    if (parameter == NULL || window->touch.what < TOUCH_SWATCH)
        return;
    for (int k = first; k < behind; k++)
        parameter->value[k] = parameter->initial[k];
    window_changed(window);
}

static void drag(struct window *window, const struct window_event *event)
{
    int width = 0, height = 0, first, behind;
    glfwGetWindowSize(window->handle, &width, &height);
    if (window->touch.what == TOUCH_TITLE && width > 0) {
        window->panel.right = event->place[0] > 0.5 * width;
        window->dirty = true;
    }
    struct parameter *parameter = window_taken(window, &first, &behind);
    if (parameter == NULL || window->touch.what != TOUCH_VALUE || event->amount != 0)
        return;
    const double way[2] = {event->way[0], 0.0};
    float right[2];
    window_overlay_place(window, way, right);
    double fine = window->input.held[WINDOW_KEY_FASTER] ? FINE : 1.0;
    for (int k = first; k < behind; k++) {
        window->touch.place[k] += fine * (double)(right[0] / window->touch.width);
        parameter_put(parameter, k, window->touch.place[k]);
    }
    window_changed(window);
}

static void click(struct window *window)
{
    int first, behind;
    struct parameter *parameter = window_taken(window, &first, &behind);
    if (window->touch.what == TOUCH_MARK)
        window->panel.rolled = !window->panel.rolled;
    if (window->touch.what == TOUCH_SWATCH)
        window_pick_open(window);
    if (window->touch.what != TOUCH_SWITCH || parameter == NULL)
        return;
    parameter_put(parameter, 0, parameter_place(parameter, 0) < 0.5 ? 1.0 : 0.0);
    window_changed(window);
}

// ---- The wheel, and a pointer that only points ----

bool window_touch_wheel(struct window *window, const struct window_event *event)
{
    const struct panel_row *row = row_at(window, event->place);
    struct parameter *parameter = parameter_of(window, row);
    if (!window_touch_claims(window, event->place))
        return false;
    window->touch.notches += event->way[0];
    int presses = (int)trunc(window->touch.notches);
    window->touch.notches -= presses;
    if (parameter == NULL || presses == 0)
        return true;
    struct parameter next = *parameter;
    parameter_change(&next,
                     is_switch(parameter) && parameter->type == PARAMETER_BOOL ? 1 : presses);
    for (int k = 0; k < parameter->components; k++)
        if (row->part < 0 || row->part == k)
            parameter->value[k] = next.value[k];
    window_changed(window);
    return true;
}

static void show_cursor(struct window *window, const struct panel_row *row, float x, bool picker,
                        bool divider)
{
    static const int shapes[] = {0, GLFW_HAND_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_CROSSHAIR_CURSOR};
    const struct parameter *parameter = parameter_of(window, row);
    int which = 0;
    if (picker)
        which = 3;
    else if (parameter != NULL)
        which = is_switch(parameter) || panel_row_is_swatch(row, x) ? 1 : 2;
    else if (row != NULL && row->kind == PANEL_ROW_TITLE)
        which = panel_row_is_mark(row, x) ? 1 : 2;
    else if (row == NULL && divider)
        which = 2;
    if (which == window->touch.cursor)
        return;
    window->touch.cursor = which;
    if (which > 0 && window->touch.cursors[which] == NULL)
        window->touch.cursors[which] = glfwCreateStandardCursor(shapes[which]);
    glfwSetCursor(window->handle, which > 0 ? window->touch.cursors[which] : NULL);
}

void window_touch_point(struct window *window, const struct window_event *event)
{
    const struct panel_row *row = row_at(window, event->place);
    int parameter = row != NULL ? row->parameter : -1;
    float at[2];
    window_overlay_place(window, event->place, at);
    show_cursor(window, row, at[0], window_pick_at(window, event->place),
                !window_touch_claims(window, event->place) &&
                    window_at_divider(window, event->place));
    window->touch.rests_at = glfwGetTime();
    memcpy(window->touch.at, at, sizeof at);
    if (parameter == window->touch.pointed)
        return;
    window->dirty |= window->touch.tip;
    window->touch.tip = false;
    window->touch.pointed = parameter;
}

void window_touch_rest(struct window *window)
{
    window_pick_rest(window);
    bool due = window->touch.pointed >= 0 && !window->touch.tip && window->hand.who == HAND_NONE &&
               !window->input.captured && glfwGetTime() >= window->touch.rests_at + TIP_SECONDS;
    window->touch.tip |= due;
    window->dirty |= due;
}

// A press outside of an open picker closes it, and does nothing else, but in the panel. A second
// press of a double one on the swatch leaves it open. Returns false for what is the panel's.
static bool press_picker(struct window *window, const struct window_event *event)
{
    const struct panel_row *row = row_at(window, event->place);
    bool again = event->action == WINDOW_DOUBLE && window->touch.what == TOUCH_SWATCH;
    float at[2];
    window_overlay_place(window, event->place, at);
    if (!window->input.picking || again)
        return false;
    window->touch.what = TOUCH_NOTHING;
    if (window_pick_at(window, event->place)) {
        window->touch.what = TOUCH_PICKER;
        return true;
    }
    window_pick_close(window);
    return row == NULL || (row->chosen && panel_row_is_swatch(row, at[0]));
}

static bool touch_picker(struct window *window, const struct window_event *event)
{
    bool down = event->action == WINDOW_PRESS || event->action == WINDOW_DOUBLE;
    if (down ? !press_picker(window, event) : window->touch.what != TOUCH_PICKER)
        return false;
    if (window->touch.what == TOUCH_PICKER && event->action != WINDOW_RELEASE)
        window_pick(window, event);
    return true;
}

void window_touch(struct window *window, const struct window_event *event)
{
    window->dirty = true;
    window->touch.tip = false;
    window->touch.rests_at = glfwGetTime();
    if (touch_picker(window, event))
        return;
    if (event->action == WINDOW_PRESS) {
        window_field_leave(window);
        press(window, event);
        if (event->amount == 1)
            reset(window);
    } else if (event->action == WINDOW_DOUBLE) {
        window_field_open(window);
    } else if (event->action == WINDOW_DRAG) {
        drag(window, event);
    } else if (event->action == WINDOW_RELEASE && event->amount == 1 && window->touch.button == 0) {
        click(window);
    }
    if (event->action == WINDOW_PRESS)
        window->touch.button = event->amount;
}

// What the panel is told of all this.
void window_touch_tell(struct window *window, struct panel *panel, char tip[512])
{
    int pointed = window->touch.pointed;
    const struct parameter *below = pointed >= 0 ? pair_parameter(window->renderer, pointed) : NULL;
    panel->right = window->panel.right;
    panel->rolled = window->panel.rolled;
    panel->tip = tip;
    memcpy(panel->tip_at, window->touch.at, sizeof panel->tip_at);
    tip[0] = '\0';
    if (window->touch.tip && !window->input.picking && below != NULL)
        snprintf(tip, 512, "%s", below->meaning);
    window_field_tell(window, panel, tip);
    window_pick_tell(window, panel);
}
