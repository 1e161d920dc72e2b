// keys.h - the table of keys: what a key does in a window, what the overlay's list says of it, and
// what
// --help and docs/using.md say of it.
#ifndef WINDOW_KEYS_H
#define WINDOW_KEYS_H

#include <stdbool.h>

struct window;

// When a row's keys act, and the overlay lists them.
enum key_condition {
    KEY_ALWAYS,
    KEY_WITH_CAMERA, // the shader reads the camera
    KEY_WITH_MARCH,  // the shader records its march
    KEY_WITH_TIME,   // the picture changes with time
    KEY_WITH_EDITOR, // not in a web page
    KEY_WITH_RAY,
    KEY_WITH_PARAMETERS,
    KEY_WITH_HANDLES,
    KEY_WITH_TOOL,
    KEY_WITH_PROJECTIONS,
    KEY_WITH_SCENES, // in a course or a lecture
    KEY_IN_COURSE,
    KEY_IN_LECTURE
};

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

// True in a course or a lecture, where keys change the scene.
bool window_has_scenes(const struct window *window);

// True if the keys of a row act on what the window shows.
bool window_key_acts(struct window *window, enum key_condition condition);

// If the keys of a row do nothing here, and have no other meaning, let the overlay say why, once.
void window_explain_key(struct window *window, enum key_condition condition);

// List the keys with the labels of the user's keyboard, and set the hint, which names the key that
// lists more or fewer keys and the key that hides the overlay.
void window_list_keys(struct window *window);

#endif
