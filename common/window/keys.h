// keys.h - the overlay's list of keys.
#ifndef WINDOW_KEYS_H
#define WINDOW_KEYS_H

#include "window/state.h"

// List the keys with the labels of the user's keyboard, and set the hint that names the keys for
// showing more and for hiding the overlay.
void window_list_keys(struct window *window);

#endif
