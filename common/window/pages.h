// pages.h - goes from scene to scene: from chapter to chapter of the course, or through a lecture,
// with a black screen in between.
#ifndef WINDOW_PAGES_H
#define WINDOW_PAGES_H

#include "window/state.h"

// Ask for the scene that is `by` scenes further. Holding the key does not repeat the request.
// Presses that pile up while a scene is compiled count once; otherwise an impatient speaker would
// skip scenes. Outside the course and lectures, say what has scenes.
void window_change_scene(struct window *window, int by);

// Do what Page Down (by = 1) and Page Up (by = -1) do: if the scene began at a step of a ray, go to
// the ray's next step while there is one; otherwise change the scene.
void window_turn_page(struct window *window, int by);

// The same for a key that is held, which only steps along the ray.
void window_step_by_page(struct window *window, int by);

// In a lecture, Shift with a digit from 1 to 9 asks for a part. Returns true for such a key.
bool window_ask_part(struct window *window, const struct window_event *event);

// Make the screen black, if there are scenes.
void window_blacken(struct window *window);

// On a black screen, a click or a key other than those that change the scene only ends the black,
// because what else it did would not be seen. Returns true for such an event.
bool window_ends_black(struct window *window, const struct window_event *event);

#endif
