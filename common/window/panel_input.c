#include "window/panel_input.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/comparison.h"
#include "window/colour_picker.h"
#include "window/condition.h"
#include "window/field.h"
#include "window/ray.h"
#include "window/selection.h"

#define TIP_SECONDS 0.5 // for which the pointer rests before a tooltip appears
#define FINE        0.1 // factor of a drag's movement while Left Shift is held

// Return the row at a position, or NULL if there is none or the open picker covers the position.
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

// Return what a press on a row would grab.
static enum panel_grab grab_of(const struct window *window, const struct panel_row *row, float x)
{
    const struct parameter *parameter = parameter_of(window, row);
    if (row != NULL && row->kind == PANEL_ROW_TITLE)
        return panel_row_is_mark(row, x) ? GRAB_MARK : GRAB_TITLE;
    if (row != NULL && row->kind == PANEL_ROW_STATUS)
        return row->cell[1][0] != '\0' ? GRAB_STATUS : GRAB_NOTHING;
    if (row != NULL && row->kind == PANEL_ROW_VIEW)
        return GRAB_VIEW;
    if (row != NULL && row->kind == PANEL_ROW_MORE)
        return row->part >= 0 ? GRAB_MORE : GRAB_NOTHING;
    if (row != NULL && panel_row_button(row, x) >= 0)
        return GRAB_BUTTON;
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
        [GRAB_STATUS] = SHAPE_HAND,   [GRAB_VIEW] = SHAPE_HAND,    [GRAB_BUTTON] = SHAPE_HAND,
        [GRAB_MORE] = SHAPE_HAND,     [GRAB_SWATCH] = SHAPE_HAND,  [GRAB_SWITCH] = SHAPE_HAND,
        [GRAB_VALUE] = SHAPE_RESIZE};
    return shapes[grab_of(window, row_at(window, unit), unit[0])];
}

// Keep the components of a parameter shown, so that no row moves when the pointer selects another
// parameter.
static void keep_open(struct window *window, const struct parameter *parameter)
{
    int index = 0;
    while (parameter != NULL && comparison_parameter(window->renderer, index) != parameter)
        index++;
    if (parameter != NULL && index < 64)
        window->panel.open |= 1ULL << index;
}

static void press(struct window *window, const struct window_event *event)
{
    const struct panel_row *row = row_at(window, event->unit);
    const struct parameter *parameter = parameter_of(window, row);
    window->grab.what = grab_of(window, row, event->unit[0]);
    window->grab.button = event->amount;
    if (row != NULL)
        window->grab.choice =
            row->kind == PANEL_ROW_BUTTONS ? panel_row_button(row, event->unit[0]) : row->part;
    if (parameter == NULL)
        return;
    keep_open(window, window_selected(window));
    window->grab.part = row->part;
    window->grab.width = row->width;
    window_select(window, parameter, row->part);
    for (int k = 0; k < parameter->components; k++)
        window->grab.fraction[k] = parameter_fraction(parameter, k);
}

static void drag(struct window *window, const struct window_event *event)
{
    int first, end;
    double right = (double)(event->unit[0] - window->grab.at[0]);
    struct parameter *parameter = window_grabbed(window, &first, &end);
    if (window->grab.what == GRAB_TITLE) {
        window->panel.right = event->pixel[0] > 0.5 * window->inputs.width;
        window->panel.room = ROOM_DECIDED;
    }
    if (window->grab.what != GRAB_VALUE || window->grab.button != 0 || parameter == NULL)
        return;
    if (window->input.held[HELD_FASTER])
        right *= FINE;
    for (int k = first; k < end; k++) {
        window->grab.fraction[k] += right / (double)window->grab.width;
        parameter_put(parameter, k, window->grab.fraction[k]);
    }
    window_parameter_changed(window);
}

static void click_button(struct window *window)
{
    if (window->grab.choice == PANEL_PAUSE)
        window_pause(window);
    else if (window->grab.choice == PANEL_HIDE) {
        window->panel.folded = true;
        window->panel.captioned = false;
    } else
        window_step(window, window->grab.choice == PANEL_STEP_ON ? 1 : -1);
    window->title.due = 0.0;
}

// If there is no room for all parameters, select one that is not shown, so that the list moves to
// it.
//   last  the number of the last parameter that is shown
//   by    1 for the parameters after those, -1 for the ones before
static void turn_list(struct window *window, int last, int by)
{
    int count = comparison_parameter_count(window->renderer), from = window->panel.rows.from;
    int next = by < 0 ? from - 1 : last + (last - from) - 1;
    next = by > 0 && last == count ? 0 : next >= count ? count - 1 : next < 0 ? 0 : next;
    window_select(window, comparison_parameter(window->renderer, next), -1);
}

// Handle a click on anything but the parameters. A click on the mark of a folded panel unfolds the
// panel.
static void click_words(struct window *window)
{
    bool *mark = window->panel.folded ? &window->panel.folded : &window->panel.rolled;
    if (window->grab.what == GRAB_MARK) {
        *mark = !*mark;
        window->panel.room = ROOM_DECIDED;
        window->panel.captioned |= mark == &window->panel.folded;
    } else if (window->grab.what == GRAB_STATUS)
        window->panel.views = !window->panel.views;
    else if (window->grab.what == GRAB_VIEW)
        window_show_view(window, window->grab.choice);
    else if (window->grab.what == GRAB_MORE)
        turn_list(window, window->grab.choice, 1);
    else if (window->grab.what == GRAB_BUTTON)
        click_button(window);
}

static void click(struct window *window)
{
    int first, end;
    struct parameter *parameter = window_grabbed(window, &first, &end);
    bool resets = window->grab.button != 0;
    if (!resets)
        click_words(window);
    if (window->grab.what < GRAB_SWATCH || parameter == NULL)
        return;
    if (resets)
        window_copy_parts(parameter, parameter->initial, window->grab.part);
    else if (window->grab.what == GRAB_SWATCH)
        window_picker_open(window);
    else if (window->grab.what == GRAB_SWITCH)
        parameter_put(parameter, 0, parameter_fraction(parameter, 0) < 0.5 ? 1.0 : 0.0);
    else
        window->input.armed = true;
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
    if (event->kind != EVENT_HOVER) // a drag begins at the press, even after a hover
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
    if (row != NULL && row->kind == PANEL_ROW_MORE && presses != 0)
        turn_list(window, row->part, presses < 0 ? 1 : -1);
    if (parameter == NULL || presses == 0)
        return true;
    struct parameter next = *parameter;
    parameter_change(&next, parameter->type == PARAMETER_BOOL ? 1 : presses);
    window_copy_parts(parameter, next.value, row->part);
    window_parameter_changed(window);
    window_begin_hour(window, parameter); // which need not be the selected one
    return true;
}

// True if the pointer is where a folded panel shows its title. While the title is hidden, the panel
// has no rows, so panel_rows_hold would always return false.
static bool peeks(const struct window *window, const float unit[2])
{
    const struct panel_rows *rows = &window->panel.rows;
    return window->panel.folded && !window->panel.in_page && !window->input.captured &&
           window->pointer.owner != OWNER_PICTURE && unit[0] >= rows->left &&
           unit[1] >= rows->top && unit[0] < rows->left + rows->width &&
           unit[1] < rows->top + rows->height;
}

void window_panel_hover(struct window *window, const struct window_event *event)
{
    window->grab.rests_since = glfwGetTime();
    memcpy(window->grab.at, event->unit, sizeof event->unit);
}

// Follow the parameter under the pointer. The rows that open on demand close only when the pointer
// has left the panel, so that no row moves away from under the pointer.
static void update_rows(struct window *window)
{
    const struct panel_row *row = row_at(window, window->grab.at);
    int parameter = row != NULL ? row->parameter : -1;
    bool peeking = peeks(window, window->grab.at);
    window->dirty |= peeking != window->panel.peeks;
    window->panel.peeks = peeking;
    if (window->pointer.owner != OWNER_NONE)
        return;
    if (parameter != window->grab.hovered) { // the pointer or the rows have moved
        window->dirty |= window->grab.tip;
        window->grab.tip = false;
        window->grab.hovered = parameter;
    }
    if (window_panel_covers(window, window->grab.at))
        return;
    window->input.armed = false;
    window->dirty |= window->panel.views || window->panel.open != 0;
    window->panel.views = false;
    window->panel.open = 0;
}

void window_panel_rest(struct window *window)
{
    update_rows(window);
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
    panel->peeks = window->panel.peeks;
    panel->views = window->panel.views;
    panel->still = window_panel_covers(window, window->grab.at);
    panel->open = window->panel.open;
    panel->buttons = !window->panel.in_page;
    panel->table = &window->panel.table;
    panel->tip = tip;
    memcpy(panel->tip_at, window->grab.at, sizeof panel->tip_at);
    snprintf(tip, 512, "%s%s", shown ? below->meaning : "",
             shown && !is_switch(below) ? " (drag it, or click and type)" : "");
    window_field_fill(window, panel, tip);
    window_picker_fill(window, panel);
}
