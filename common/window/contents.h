// contents.h - the sheet of contents: a small picture of each chapter with its name. The mouse or
// the arrow keys choose one.
#ifndef WINDOW_CONTENTS_H
#define WINDOW_CONTENTS_H

#include "window/state.h"

// Show the sheet, or hide it again.
void window_toggle_contents(struct window *window);

// Let the sheet handle an event. Choosing an item hides the sheet and asks for its scene. Returns
// true if the event has no other effect.
bool window_contents_input(struct window *window, struct window_event *event);

// Draw the sheet into the window's framebuffer. Returns false after reporting the error if the
// driver cannot.
bool window_contents_draw(struct window *window);

// Free the sheet. It may never have been shown.
void window_contents_close(struct window *window);

#endif
