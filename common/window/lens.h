// lens.h - focal length, and the transition between perspective and orthographic view.
#ifndef WINDOW_LENS_H
#define WINDOW_LENS_H

#include "window/state.h"

// Change the focal length or, in the slice and plot views, the zoom by a number of wheel notches.
void window_zoom(struct window *window, double notches);

// Undo what window_zoom has changed since the window's scene was opened.
void window_reset_zoom(struct window *window);

// True if the shader has both projections: it has a parameter named orthographic, or it reads the
// input iOrthoView or OrthoView.
bool window_has_orthographic(struct window *window);

// Begin the transition to the other projection. During a transition, reverse it.
void window_toggle_orthographic(struct window *window);

// Continue the transition. Returns true if this has changed the picture.
//   seconds  since the last iteration of the main loop
bool window_continue_transition(struct window *window, double seconds);

#endif
