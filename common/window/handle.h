// handle.h - handles: points in the picture that the pointer drags. The arrow keys move the focused
// handle.
#ifndef WINDOW_HANDLE_H
#define WINDOW_HANDLE_H

#include "window/state.h"

// Return the index of the handle at a position, in units of the overlay; -1 if there is none, or if
// the panel covers the handle.
int window_handle_at(const struct window *window, const float unit[2]);

// True if a press grabs a handle. That handle is then focused; a press beside all handles focuses
// none.
bool window_handle_claims(struct window *window, const struct window_event *press);

// Drag the grabbed handle.
void window_handle_input(struct window *window, const struct window_event *event);

// Focus the next handle, or none after the last one.
void window_next_handle(struct window *window);

// Move the focused handle by this many key presses to the right and up. Returns false if no handle
// is focused, or handles are not shown.
bool window_nudge_handle(struct window *window, int right, int up);

// Find the positions of the handles, and move the one that is dragged or nudged. Call this at most
// once per iteration of the main loop, before the picture is drawn. Returns false after reporting
// the error.
bool window_place_handles(struct window *window);

// If the panel that has just been laid out covers a handle, move it to the right or, if it is
// there, collapse it. A figure in the plane has its numbers at the top left, so its panel is
// on the right in any case. Does so only when a picture is first shown, and not after the user has
// moved the panel.
//   moves    how often this frame's panel has been moved
//   returns  true if it must be laid out again
bool window_uncover_handles(struct window *window, int moves);

// Add the handles to the overlay's frame.
void window_draw_handles(struct window *window);

#endif
