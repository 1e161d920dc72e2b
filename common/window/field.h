// field.h - the field in which a value is typed.
#ifndef WINDOW_FIELD_H
#define WINDOW_FIELD_H

#include "window/state.h"

// Open the field for the value that the last press grabbed, or close the field.
void window_field_open(struct window *window);
void window_field_close(struct window *window);

// Handle one typed character, or a code such as INPUT_ENTER.
void window_field_type(struct window *window, int code);

// Set the panel's members for the field.
//   tip  room for a message; must live as long as the panel
void window_field_fill(const struct window *window, struct panel *panel, char tip[512]);

#endif
