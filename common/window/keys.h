// keys.h - the table of keys: what a key does in a window, and what the overlay's list, --help and
// docs/using.md say of it.
#ifndef WINDOW_KEYS_H
#define WINDOW_KEYS_H

#include "window/condition.h"

// What a key does. A key that acts while it is held down is in input.c instead.
struct key_binding {
    int key;                                           // GLFW's name; 0 after the last binding
    void (*act)(struct window *window);                // called unless it is NULL
    void (*change)(struct window *window, int amount); // called if act is NULL
    int amount, shifted; // the argument of change without and with Shift
    int count;           // if not 0, the number of keys from key on; each adds 1 to the argument
    bool repeats;        // also while the key is held
};

enum { KEY_BINDINGS = 4 }; // maximum number in a row

struct key_row {
    const char *label;   // the keys, separated by blanks; a letter or a digit that is alone names a
                         // key of an American keyboard
    const char *does;    // in the overlay's list
    const char *meaning; // in --help and on the page
    enum key_condition condition;
    struct key_binding binding[KEY_BINDINGS];
};

// All rows, in actions.c; the label of the last one is NULL. Without GLFW there are none.
extern const struct key_row window_keys[];

// List the keys with the labels of the user's keyboard, and set the hint, which names the key that
// lists more or fewer keys and the key that hides the overlay.
void window_list_keys(struct window *window);

#endif
