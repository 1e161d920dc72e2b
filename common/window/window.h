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
// Returns the window, which the caller closes; NULL after reporting the error.
struct window *window_open(struct context *context, const struct window_start *start);

// Show something else in the same window, with its own camera, time, view and parameters.
//   start    must outlive the window, or the next call
//   at_last  with a selected ray: show all its steps, instead of start's
void window_show(struct window *window, const struct window_start *start, bool at_last);

// In a lecture: 1 if the speaker has asked for the next scene since the last call, -1 for the one
// before, or 0.
//   part  receives the part of the lecture that was asked for, from 1; 0 if there is none
int window_asked(struct window *window, int *part);

// True if a moment of computing disturbs nobody: the last turn has drawn nothing, or a moving
// picture has been shown for two seconds.
bool window_idles(const struct window *window);

// Show a message where the reader is looking, until the next view or scene.
void window_warn(struct window *window, const char *text);

// Fill the screen.
void window_fill_screen(struct window *window);

// Act on the input since the last turn and draw what is due, without waiting.
// Reports an error and returns false if drawing failed.
bool window_turn(struct window *window);

// Run at most 60 turns per second until the window is closed.
//   turned  called with to after each turn, unless it is NULL
// Reports an error and returns false if drawing failed.
bool window_run(struct window *window, void (*turned)(void *to), void *to);

// Free the loop's memory; the context's window stays. NULL is allowed.
void window_close(struct window *window);

#endif
