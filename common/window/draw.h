// draw.h - draws the frames, the title bar and the overlay.
#ifndef WINDOW_DRAW_H
#define WINDOW_DRAW_H

#include "window/state.h"

// Show the chapter, the view and the selected parameter in the title bar.
void window_retitle(struct window *window);

// True if the picture on the screen is coarse and has been at rest for long enough to be sharpened.
// Frames that are kept are never sharpened, because they would begin again at another size.
//   now  the current time, from glfwGetTime
bool window_sharpens(const struct window *window, double now);

// Draw a frame with its overlay: the picture if it is stale, otherwise some rows of the sharp
// picture if sharpening is due.
//   now  the current time, from glfwGetTime
// Returns false after reporting the error.
bool window_draw(struct window *window, double now);

#endif
