// pointer.h - which part of the window owns the pointer.
#ifndef WINDOW_POINTER_H
#define WINDOW_POINTER_H

#include "window/state.h"

// Handle an event of the pointer. Returns false for any other event, and for the wheel outside
// the panel.
bool window_pointer_input(struct window *window, struct window_event *event);

// Update everything that depends on the pointer. Call this once per iteration of the main loop,
// after the events.
void window_pointer_rest(struct window *window);

#endif
