// actions.h - acts on the input from keyboard and pointer.
#ifndef WINDOW_ACTIONS_H
#define WINDOW_ACTIONS_H

#include "window/state.h"

// Act on the input since the last iteration of the main loop.
void window_act(struct window *window);

#endif
