// field.h - the field in which a value is typed.
#ifndef WINDOW_FIELD_H
#define WINDOW_FIELD_H

#include "window/state.h"

// Open the field for the value that the last press grabbed, and close it.
void window_field_open(struct window *window);
void window_field_close(struct window *window);

// Handle one character, or INPUT_ENTER and the like.
void window_field_type(struct window *window, int code);

// Set what the panel shows of the field.
//   tip  room for a message, which the panel keeps
void window_field_fill(const struct window *window, struct panel *panel, char tip[512]);

#endif
