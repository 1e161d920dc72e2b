// stroke.h - strokes: dragging the pointer over the chapter's volume changes the volume.
#ifndef WINDOW_STROKE_H
#define WINDOW_STROKE_H

#include "window/state.h"

// True if the chapter has a tool whose amount is not 0, and the view is not the slice or the plot.
bool window_has_tool(const struct window *window);

// True if a press begins a stroke, because the tool finds something to work on there.
bool window_stroke_claims(struct window *window, const struct window_event *press);

// Continue the stroke, or end it and print it.
void window_stroke_input(struct window *window, const struct window_event *event);

// Add the point under the pointer to the stroke, because the pointer or the scene may have moved.
// Call this once per iteration of the main loop, after the events.
void window_stroke_rest(struct window *window);

// Take back at most this many of the last strokes. Nothing happens while a stroke is being made.
void window_take_back(struct window *window, int count);

#endif
