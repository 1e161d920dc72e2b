// panel_input.h - handles the pointer on the panel.
#ifndef WINDOW_PANEL_INPUT_H
#define WINDOW_PANEL_INPUT_H

#include "window/state.h"

// True if the panel covers a position, in units of the overlay.
bool window_panel_covers(const struct window *window, const float unit[2]);

// Return the shape of the pointer at a position on the panel.
enum pointer_shape window_panel_shape(const struct window *window, const float unit[2]);

// Handle a press on the panel and the events that follow, up to the release.
void window_panel_input(struct window *window, const struct window_event *event);

// Handle the wheel. Returns false if the pointer is not on the panel.
bool window_panel_wheel(struct window *window, const struct window_event *event);

// Handle a pointer that moves while no button is held.
void window_panel_hover(struct window *window, const struct window_event *event);

// Show a tooltip once the pointer has rested for long enough. Call this once per iteration of the
// main loop.
void window_panel_rest(struct window *window);

// Set the panel's members for the pointer, the field and the colour picker.
//   tip  room for the tooltip's text; must live as long as the panel
void window_panel_fill(struct window *window, struct panel *panel, char tip[512]);

#endif
