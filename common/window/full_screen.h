// full_screen.h - full screen, and back to a window.
#ifndef WINDOW_FULL_SCREEN_H
#define WINDOW_FULL_SCREEN_H

#include "window/state.h"

// Fill the monitor below the window, or restore the window. In a web page, where only the page may
// do this, nothing happens.
void window_toggle_full_screen(struct window *window);

#endif
