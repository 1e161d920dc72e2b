// keys.h - the overlay's list of keys.
#ifndef WINDOW_KEYS_H
#define WINDOW_KEYS_H

#include "window/state.h"

// List the keys with the labels of the user's keyboard, and set the hint, which names the key that
// lists more or fewer keys and the key that hides the overlay.
void window_list_keys(struct window *window);

#endif
