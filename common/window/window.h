// window.h - the interactive loop: input, reload, frames, the title bar.
//
// A program opens a window, runs it and closes it. Callers with their own main loop, such as a
// browser, call window_turn instead of window_run.
#ifndef WINDOW_H
#define WINDOW_H

#include <stdbool.h>

#include "context/context.h"
#include "window/start.h"

struct window;

// Open the loop.
//   context  with a visible window
//   start    must outlive the window, as the context must
// Returns the window, which the caller closes; NULL, reported.
struct window *window_open(struct context *context, const struct window_start *start);

// Carry out the input since the last turn and draw what is due, without waiting.
// Returns false, reported, if drawing failed.
bool window_turn(struct window *window);

// Run at most 60 turns per second until the window is closed.
// Returns false, reported, if drawing failed.
bool window_run(struct window *window);

// Free the loop's memory; the context's window stays. NULL is allowed.
void window_close(struct window *window);

#endif
