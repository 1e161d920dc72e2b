// ray.h - the selected ray and its playback.
#ifndef WINDOW_RAY_H
#define WINDOW_RAY_H

#include "window/state.h"

// Select the current camera's ray through a pixel.
void window_select_ray(struct window *window, const int pixel[2]);

void window_deselect_ray(struct window *window);

// Handle a click on the picture: select the ray of the clicked pixel, or deselect the ray if it is
// already selected.
//   pixel  position in pixels from the picture's bottom left, not rounded
void window_click_ray(struct window *window, const double pixel[2]);

// Keep the selected ray when the picture changes size: its pixel becomes the one at the ray's
// position on the screen. If the picture has become too narrow for that, the ray is deselected.
//   width, height  the new size, in pixels
void window_resize_ray(struct window *window, int width, int height);

// Step along the selected ray. If no ray is selected and the shader records its rays, select the
// ray of the middle pixel first.
//   by  number of steps forwards; negative for backwards
void window_step(struct window *window, int by);

// Go to the selected ray's first or last step. Returns false if no ray is selected, or if
// the ray has no march.
bool window_step_to(struct window *window, bool last);

// True if the table of the ray's march covers a position, in units of the overlay.
bool window_table_covers(const struct window *window, const float unit[2]);

// Handle the pointer on the table: a click on the line of a step goes to that step.
void window_table_input(struct window *window, const struct window_event *event);

// March the selected ray with this frame's parameters and time. A ray whose pixel is no longer in
// the window is deselected.
void window_follow_ray(struct window *window);

#endif
