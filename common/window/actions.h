// actions.h - carries out what keyboard and pointer ask for.
#ifndef WINDOW_ACTIONS_H
#define WINDOW_ACTIONS_H

#include "window/state.h"

// Act on the input since the last turn.
void window_act(struct window *window);

#endif
