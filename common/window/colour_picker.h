// colour_picker.h - the colour picker of the selected parameter.
#ifndef WINDOW_COLOUR_PICKER_H
#define WINDOW_COLOUR_PICKER_H

#include "window/state.h"

// Open the picker for the selected colour, or close the picker.
void window_picker_open(struct window *window);
void window_picker_close(struct window *window);

// True if the open picker covers a position, in units of the overlay.
bool window_picker_covers(const struct window *window, const float unit[2]);

// True if a press belongs to the open picker. A press outside the picker closes the picker, and has
// no other effect unless it is on a row of the panel and not on the colour's own swatch. But the
// second press of a double click on that swatch leaves the picker open.
bool window_picker_claims(struct window *window, const struct window_event *press);

// Handle a press on the picker and the drag that follows it.
void window_picker_input(struct window *window, const struct window_event *event);

// Set the panel's members for the picker.
void window_picker_fill(struct window *window, struct panel *panel);

// Close the picker if its colour is no longer shown. Call this once per iteration of the main loop.
void window_picker_update(struct window *window);

#endif
