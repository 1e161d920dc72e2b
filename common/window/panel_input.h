// panel_input.h - the pointer on the panel.
#ifndef WINDOW_PANEL_INPUT_H
#define WINDOW_PANEL_INPUT_H

#include "window/state.h"

// True if the panel covers a position, in units of the overlay.
bool window_panel_covers(const struct window *window, const float unit[2]);

// The shape of a pointer at a position on the panel.
enum pointer_shape window_panel_shape(const struct window *window, const float unit[2]);

// Handle a press on the panel and what follows it, up to the release.
void window_panel_input(struct window *window, const struct window_event *event);

// Handle the wheel. Returns false if the pointer is not on the panel.
bool window_panel_wheel(struct window *window, const struct window_event *event);

// Handle a pointer that moves without a button.
void window_panel_hover(struct window *window, const struct window_event *event);

// Show the tooltip of a pointer that has rested for long enough. Call it once per turn.
void window_panel_rest(struct window *window);

// Set what the panel shows of the pointer, the field and the colour picker.
//   tip  room for the tooltip's text, which the panel keeps
void window_panel_fill(struct window *window, struct panel *panel, char tip[512]);

#endif
