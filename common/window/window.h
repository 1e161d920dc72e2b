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

// Prepare the interactive loop.
//   context  has a visible window; must outlive the returned window
//   start    must outlive the returned window, or remain valid until window_show is called
// Returns the window, which the caller closes, or NULL after reporting the error.
struct window *window_open(struct context *context, const struct window_start *start);

// Show other pictures in the same window, with their own camera, time, view and parameters.
//   start    must outlive the window, or remain valid until the next call
//   at_last  if start selects a ray, show all its steps instead of the first start->shown
void window_show(struct window *window, const struct window_start *start, bool at_last);

// In a lecture or a course, return 1 if the speaker has asked for the next scene since the last
// call, -1 for the previous scene, or 0 for neither.
//   part, scene  receive the part of the lecture and the scene of the course that were asked for,
//                from 1; 0 if none was
int window_asked(struct window *window, int *part, int *scene);

// True if a short computation disturbs nobody, because the last iteration drew nothing, or because
// a moving picture has been shown for two seconds.
bool window_idles(const struct window *window);

// True if the last iteration checked the shader's files, which it does about ten times per second:
// the time at which a caller checks its own files (watch_look).
bool window_looks(const struct window *window);

// Say at once which scene is being opened, before work for which the window stands still.
//   title  of the scene
void window_announce(struct window *window, const char *title);

// Show a message in the overlay, until the view or the scene changes or the shaders are reloaded.
void window_warn(struct window *window, const char *text);

// Switch to full screen, or back if the window already fills the screen.
void window_fill_screen(struct window *window);

// Run one iteration of the loop without waiting: act on the input since the last iteration, and
// draw what is due.
// Returns false after reporting the error if drawing failed.
bool window_turn(struct window *window);

// Run the loop until the window is closed, with at most about 60 frames per second.
//   turned  called with the argument to after each iteration; may be NULL
// Returns false after reporting the error if drawing failed.
bool window_run(struct window *window, void (*turned)(void *to), void *to);

// Free the loop's memory; the context's window stays. NULL is allowed.
void window_close(struct window *window);

#endif
