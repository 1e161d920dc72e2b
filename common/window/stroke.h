// stroke.h - strokes: the pointer works on the chapter's volume while it is dragged over it.
#ifndef WINDOW_STROKE_H
#define WINDOW_STROKE_H

#include "window/state.h"

// True if the chapter has a tool and its parameter is not 0.
bool window_has_tool(const struct window *window);

// True if a press begins a stroke: the tool finds something to work on there.
bool window_stroke_claims(struct window *window, const struct window_event *press);

// Go on with the stroke, or end and print it.
void window_stroke_input(struct window *window, const struct window_event *event);

// Add the point below the pointer, which the scene may have moved. Call it once per turn, after the
// events.
void window_stroke_rest(struct window *window);

// Take back at most this many of the last strokes. Nothing happens while a stroke is being made.
void window_take_back(struct window *window, int count);

#endif
