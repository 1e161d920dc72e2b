// keys.h - the overlay's list of keys.
#ifndef WINDOW_KEYS_H
#define WINDOW_KEYS_H

#include "window/state.h"

// List the keys with the labels of the reader's keyboard, and set the hint which key shows more.
void window_list_keys(struct window *window);

#endif
