#include "window/panel_input.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/comparison.h"
#include "window/colour_picker.h"
#include "window/field.h"
#include "window/selection.h"

#define TIP_SECONDS 0.5 // the pointer rests before a tooltip appears
#define FINE        0.1 // times a drag's movement while Left Shift is held

// The row at a position; NULL for one that the open picker covers.
static const struct panel_row *row_at(const struct window *window, const float unit[2])
{
    bool covered = window_picker_covers(window, unit);
    return covered ? NULL : panel_rows_at(&window->panel.rows, unit[0], unit[1]);
}

bool window_panel_covers(const struct window *window, const float unit[2])
{
    return panel_rows_hold(&window->panel.rows, unit[0], unit[1]) ||
           window_picker_covers(window, unit);
}

static struct parameter *parameter_of(const struct window *window, const struct panel_row *row)
{
    bool there = row != NULL && row->parameter >= 0;
    return there ? comparison_parameter(window->renderer, row->parameter) : NULL;
}

static bool is_switch(const struct parameter *parameter)
{
    return parameter->type == PARAMETER_BOOL ||
           (parameter->type == PARAMETER_INT && parameter->maximum - parameter->minimum <= 1.0);
}

// What a press on a row would grab.
static enum panel_grab grab_of(const struct window *window, const struct panel_row *row, float x)
{
    const struct parameter *parameter = parameter_of(window, row);
    if (row != NULL && row->kind == PANEL_ROW_TITLE)
        return panel_row_is_mark(row, x) ? GRAB_MARK : GRAB_TITLE;
    if (parameter == NULL)
        return GRAB_NOTHING;
    if (panel_row_is_swatch(row, x))
        return GRAB_SWATCH;
    return is_switch(parameter) ? GRAB_SWITCH : GRAB_VALUE;
}

enum pointer_shape window_panel_shape(const struct window *window, const float unit[2])
{
    static const enum pointer_shape shapes[] = {
        [GRAB_NOTHING] = SHAPE_ARROW, [GRAB_TITLE] = SHAPE_RESIZE, [GRAB_MARK] = SHAPE_HAND,
        [GRAB_SWATCH] = SHAPE_HAND,   [GRAB_SWITCH] = SHAPE_HAND,  [GRAB_VALUE] = SHAPE_RESIZE};
    return shapes[grab_of(window, row_at(window, unit), unit[0])];
}

static void press(struct window *window, const struct window_event *event)
{
    const struct panel_row *row = row_at(window, event->unit);
    const struct parameter *parameter = parameter_of(window, row);
    window->grab.what = grab_of(window, row, event->unit[0]);
    window->grab.button = event->amount;
    if (parameter == NULL)
        return;
    window->grab.part = row->part;
    window->grab.width = row->width;
    window_select(window, parameter);
    for (int k = 0; k < parameter->components; k++)
        window->grab.fraction[k] = parameter_place(parameter, k);
}

static void drag(struct window *window, const struct window_event *event)
{
    int first, behind;
    double right = (double)(event->unit[0] - window->grab.at[0]);
    struct parameter *parameter = window_grabbed(window, &first, &behind);
    if (window->grab.what == GRAB_TITLE)
        window->panel.right = event->pixel[0] > 0.5 * window->inputs.width;
    if (window->grab.what != GRAB_VALUE || window->grab.button != 0 || parameter == NULL)
        return;
    if (window->input.held[HELD_FASTER])
        right *= FINE;
    for (int k = first; k < behind; k++) {
        window->grab.fraction[k] += right / (double)window->grab.width;
        parameter_put(parameter, k, window->grab.fraction[k]);
    }
    window_parameter_changed(window);
}

static void click(struct window *window)
{
    int first, behind;
    struct parameter *parameter = window_grabbed(window, &first, &behind);
    bool resets = window->grab.button != 0;
    if (window->grab.what == GRAB_MARK && !resets)
        window->panel.rolled = !window->panel.rolled;
    if (window->grab.what < GRAB_SWATCH || parameter == NULL)
        return;
    if (resets)
        memcpy(parameter->value + first, parameter->initial + first,
               (size_t)(behind - first) * sizeof *parameter->value);
    else if (window->grab.what == GRAB_SWATCH)
        window_picker_open(window);
    else if (window->grab.what == GRAB_SWITCH)
        parameter_put(parameter, 0, parameter_place(parameter, 0) < 0.5 ? 1.0 : 0.0);
    if (resets || window->grab.what == GRAB_SWITCH)
        window_parameter_changed(window);
}

void window_panel_input(struct window *window, const struct window_event *event)
{
    window->dirty = true;
    window->grab.tip = false;
    window->grab.rests_since = glfwGetTime();
    if (event->kind == EVENT_PRESS) {
        window_field_close(window);
        press(window, event);
    } else if (event->kind == EVENT_DOUBLE_PRESS) {
        window_field_open(window);
    } else if (event->kind == EVENT_DRAG) {
        drag(window, event);
    } else if (event->kind == EVENT_RELEASE && event->amount == 1) {
        click(window);
    }
    if (event->kind != EVENT_HOVER) // after which a drag may still begin at the press
        memcpy(window->grab.at, event->unit, sizeof event->unit);
}

bool window_panel_wheel(struct window *window, const struct window_event *event)
{
    const struct panel_row *row = row_at(window, event->unit);
    struct parameter *parameter = parameter_of(window, row);
    if (!window_panel_covers(window, event->unit))
        return false;
    window->grab.notches += event->movement[0];
    int presses = (int)trunc(window->grab.notches);
    window->grab.notches -= presses;
    if (parameter == NULL || presses == 0)
        return true;
    struct parameter next = *parameter;
    parameter_change(&next, parameter->type == PARAMETER_BOOL ? 1 : presses);
    for (int k = 0; k < parameter->components; k++)
        if (row->part < 0 || row->part == k)
            parameter->value[k] = next.value[k];
    window_parameter_changed(window);
    return true;
}

void window_panel_hover(struct window *window, const struct window_event *event)
{
    const struct panel_row *row = row_at(window, event->unit);
    int parameter = row != NULL ? row->parameter : -1;
    window->grab.rests_since = glfwGetTime();
    memcpy(window->grab.at, event->unit, sizeof event->unit);
    if (parameter == window->grab.hovered)
        return;
    window->dirty |= window->grab.tip;
    window->grab.tip = false;
    window->grab.hovered = parameter;
}

void window_panel_rest(struct window *window)
{
    bool due = window->grab.hovered >= 0 && !window->grab.tip &&
               window->pointer.owner == OWNER_NONE && !window->input.captured &&
               glfwGetTime() >= window->grab.rests_since + TIP_SECONDS;
    window->grab.tip |= due;
    window->dirty |= due;
}

void window_panel_fill(struct window *window, struct panel *panel, char tip[512])
{
    int hovered = window->grab.hovered;
    const struct parameter *below =
        hovered >= 0 ? comparison_parameter(window->renderer, hovered) : NULL;
    bool shown = window->grab.tip && !window->input.picker_open && below != NULL;
    panel->right = window->panel.right;
    panel->rolled = window->panel.rolled;
    panel->tip = tip;
    memcpy(panel->tip_at, window->grab.at, sizeof panel->tip_at);
    snprintf(tip, 512, "%s", shown ? below->meaning : "");
    window_field_fill(window, panel, tip);
    window_picker_fill(window, panel);
}
