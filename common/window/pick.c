// The picker of the chosen colour, by the pointer.
#include "window/state.h"

void window_pick_open(struct window *window)
{
    struct picker *picker = &window->touch.picker;
    const struct parameter *colour = window_chosen(window);
    if (colour == NULL || !parameter_is_colour(colour))
        return;
    // What is not black, and not what the colour has, so that it is read.
    *picker = (struct picker){.value = {colour->value[0] - 1.0}};
    window->input.picking = window->dirty = true;
}

void window_pick_close(struct window *window)
{
    window->dirty |= window->input.picking;
    window->input.picking = false;
}

bool window_pick_at(const struct window *window, const double place[2])
{
    float at[2];
    window_overlay_place(window, place, at);
    return window->input.picking && picker_holds(&window->touch.picker, at[0], at[1]);
}

void window_pick(struct window *window, const struct window_event *event)
{
    struct picker *picker = &window->touch.picker;
    struct parameter *colour = window_chosen(window);
    float at[2];
    window_overlay_place(window, event->place, at);
    if (event->action == WINDOW_POINT || colour == NULL)
        return;
    if (event->action != WINDOW_DRAG)
        window->touch.picked =
            event->amount == 0 ? picker_at(picker, at[0], at[1]) : PICKER_NOTHING;
    if (window->touch.picked == PICKER_NOTHING)
        return;
    picker_take(picker, colour);
    picker_drag(picker, window->touch.picked, at[0], at[1]);
    picker_give(picker, colour);
    window_changed(window);
}

void window_pick_tell(struct window *window, struct panel *panel)
{
    const struct parameter *colour = window_chosen(window);
    bool open = window->input.picking && colour != NULL && parameter_is_colour(colour);
    panel->picker = open ? &window->touch.picker : NULL;
    if (open)
        picker_take(&window->touch.picker, colour);
}

void window_pick_rest(struct window *window)
{
    const struct parameter *colour = window_chosen(window);
    bool shown = window->dirty || window->touch.picker.width > 0.0f;
    if (window->input.picking && (!shown || colour == NULL || !parameter_is_colour(colour)))
        window_pick_close(window);
}
