// full_screen.h - switches between full screen and a window.
#ifndef WINDOW_FULL_SCREEN_H
#define WINDOW_FULL_SCREEN_H

#include "window/state.h"

// Fill the monitor that shows the window, or restore the window. In a web page, this function does
// nothing, because a browser allows full screen only to the page's script.
void window_toggle_full_screen(struct window *window);

#endif
