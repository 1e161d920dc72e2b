// pointer.h - which part of the window owns the pointer.
#ifndef WINDOW_POINTER_H
#define WINDOW_POINTER_H

#include "window/state.h"

// Set the event's position in pixels of the picture and in units of the overlay.
void window_pointer_locate(const struct window *window, struct window_event *event);

// Handle an event of the pointer. Returns false for any other event, and for the wheel outside
// the panel.
bool window_pointer_input(struct window *window, struct window_event *event);

// Update everything that depends on the pointer. Call this once per iteration of the main loop,
// after the events.
void window_pointer_rest(struct window *window);

#endif
