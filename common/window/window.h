// window.h - the interactive loop: keys, mouse, reload, the title bar.
//
// A program opens a window, runs it and closes it. Who has a loop of his own, as a browser has,
// gives the window its turns instead of running it.
#ifndef WINDOW_H
#define WINDOW_H

#include <stdbool.h>

#include "context/context.h"
#include "picture/renderer.h"
#include "window/start.h"

struct window;

// Open the loop.
//   context   with a visible window
//   renderer  with the shader loaded and the view set
//   start     like the two above it must outlive the window
// Returns the window, which the caller closes; NULL, reported.
struct window *window_open(struct context *context, struct renderer *renderer,
                           const struct window_start *start);

// Carry out what the hands did since the last turn and draw what is due. It waits for nothing.
// Returns false, reported, when drawing failed.
bool window_turn(struct window *window);

// Turn after turn, 60 a second at most, until the window is closed.
// Returns false, reported, when drawing failed.
bool window_run(struct window *window);

// Free what the loop holds; the context's window stays. NULL is allowed.
void window_close(struct window *window);

#endif
