#include "window/colour_picker.h"

#include "window/selection.h"

// Return the selected parameter if it is a colour, otherwise NULL.
static struct parameter *colour_of(const struct window *window)
{
    struct parameter *parameter = window_selected(window);
    return parameter != NULL && parameter_is_colour(parameter) ? parameter : NULL;
}

void window_picker_open(struct window *window)
{
    const struct parameter *colour = colour_of(window);
    if (colour == NULL)
        return;
    // Begin with a value that the colour does not have, so that picker_take reads the colour.
    window->grab.picker = (struct picker){.value = {colour->value[0] - 1.0}};
    window->input.picker_open = window->dirty = true;
}

void window_picker_close(struct window *window)
{
    window->dirty |= window->input.picker_open;
    window->input.picker_open = false;
}

bool window_picker_covers(const struct window *window, const float unit[2])
{
    return window->input.picker_open && picker_holds(&window->grab.picker, unit[0], unit[1]);
}

bool window_picker_claims(struct window *window, const struct window_event *press)
{
    const float *unit = press->unit;
    if (!window->input.picker_open || window_picker_covers(window, unit))
        return window->input.picker_open;
    const struct panel_row *row = panel_rows_at(&window->panel.rows, unit[0], unit[1]);
    bool own = row != NULL && row->selected && panel_row_is_swatch(row, unit[0]);
    if (own && press->kind == EVENT_DOUBLE_PRESS) // the first click has just opened the picker
        return false;
    window_picker_close(window);
    return row == NULL || own;
}

void window_picker_input(struct window *window, const struct window_event *event)
{
    struct picker *picker = &window->grab.picker;
    struct parameter *colour = colour_of(window);
    float x = event->unit[0], y = event->unit[1];
    bool pressed = event->kind == EVENT_PRESS || event->kind == EVENT_DOUBLE_PRESS;
    if (pressed)
        window->grab.picked = event->amount == 0 ? picker_at(picker, x, y) : PICKER_NOTHING;
    if (!window->input.picker_open || window->grab.picked == PICKER_NOTHING || colour == NULL ||
        (!pressed && event->kind != EVENT_DRAG))
        return;
    picker_take(picker, colour);
    picker_drag(picker, window->grab.picked, x, y);
    picker_give(picker, colour);
    window_parameter_changed(window);
}

void window_picker_fill(struct window *window, struct panel *panel)
{
    const struct parameter *colour = window->input.picker_open ? colour_of(window) : NULL;
    panel->picker = colour != NULL ? &window->grab.picker : NULL;
    if (colour != NULL)
        picker_take(&window->grab.picker, colour);
}

void window_picker_update(struct window *window)
{
    bool shown = window->dirty || window->grab.picker.width > 0.0f;
    if (!shown || colour_of(window) == NULL)
        window_picker_close(window);
}
