// input.h - keyboard and pointer: gathers GLFW's events between two frames, in order.
#ifndef WINDOW_INPUT_H
#define WINDOW_INPUT_H

#include <stdbool.h>

#define GLFW_INCLUDE_NONE // OpenGL's names come from gl.h
#include <GLFW/glfw3.h>

#define WINDOW_INPUT_EVENTS 64 // maximum between two frames; further events are dropped

enum window_event_kind {
    EVENT_KEY,          // amount: GLFW's key code; shifted and repeated are set too
    EVENT_TYPED,        // amount: a character's code, or a code such as INPUT_ENTER
    EVENT_PRESS,        // amount: 0 for the left button, 1 for the right one
    EVENT_DOUBLE_PRESS, // the second press of a double click
    EVENT_RELEASE,      // amount: 1 for a click; 0 after a drag, a change of focus or the key M
    // From here on, consecutive events of the same kind are merged, and their movements added up.
    EVENT_WHEEL, // movement: notches, positive away from the user
    EVENT_LOOK,  // movement: of the captured pointer, in window units to the right and down
    EVENT_MOVE,  // movement: seconds to the right, up and forwards, times 4 while moving faster
    EVENT_DRAG,  // movement: of the pointer while a button is held, as for EVENT_LOOK
    EVENT_HOVER  // the pointer has moved, or left the window, without dragging anything
};

// Codes of typed keys that are not characters. INPUT_BEGIN comes before the first key that a number
// receives after a click.
enum { INPUT_BEGIN = 2, INPUT_BACKSPACE = 8, INPUT_ENTER = 13, INPUT_ESCAPE = 27 };

struct window_event {
    enum window_event_kind kind;
    int amount;
    bool shifted, repeated;
    double movement[3];
    // Position of the pointer, in window units from the top left; -1,-1 if the pointer is outside
    // the window or captured.
    double position[2];
    // The same position in other units, which pointer.c adds:
    double pixel[2]; // in pixels of the picture from its bottom left
    float unit[2];   // in units of the overlay from the top left; negative if unknown
};

// Keys that act as long as they are held.
enum window_held_key {
    HELD_LEFT,
    HELD_RIGHT,
    HELD_UP,
    HELD_DOWN,
    HELD_DOWN_CONTROL,
    HELD_FORWARD,
    HELD_BACK,
    HELD_FASTER,
    HELD_FASTER_F, // an alternative, because Windows opens a dialog after five presses of Shift
    HELD_KEYS
};

enum window_button_state { BUTTON_UP, BUTTON_PRESSED, BUTTON_DRAGS };

struct window_input {
    GLFWwindow *window;
    // Called as soon as the window must be drawn again, because GLFW may not return while the user
    // resizes the window. It may be NULL.
    void (*show)(void *to);
    void *to; // the argument of show
    // Since the last window_input_forget:
    struct window_event event[WINDOW_INPUT_EVENTS];
    int events;
    bool damaged;       // the window must be drawn again
    char dropped[4096]; // the first of the files that were dropped on the window; "" if there is
                        // none. The reader clears it
    // Kept from frame to frame:
    bool typing;      // a field is open, so keys are characters; set by field.c
    bool armed;       // a number was clicked, so a key that writes a number opens its field
    bool picker_open; // Escape closes the colour picker; set by colour_picker.c
    bool held[HELD_KEYS];
    double pressed[HELD_KEYS]; // time of glfwGetTime of the last press
    double counted;            // time of glfwGetTime up to which all movement is in the events
    enum window_button_state state;
    int button; // the button that is held: 0 left, 1 right
    struct {
        double time, position[2];
    } press; // the last press of the left button
    bool captured;
    bool jumped;        // the next position of the pointer does not count as movement
    double previous[2]; // the position up to which movement has been counted
    bool inside;        // position is known
    double position[2];
};

// Receive the events of a window from now on.
//   input  must outlive the window's last event
//   show   called with the argument to when the window must be drawn again; may be NULL
void window_input_open(struct window_input *input, GLFWwindow *window, void (*show)(void *to),
                       void *to);

// Add the movement from held keys up to now. Call this before reading the events.
void window_input_count(struct window_input *input);

// Forget the gathered events. Held keys stay held.
void window_input_forget(struct window_input *input);

// Capture the pointer, so that each of its movements is an EVENT_LOOK and it leaves no window, or
// release it.
void window_input_capture(struct window_input *input);

// True while a key that moves the camera is held.
bool window_input_moves(const struct window_input *input);

#endif
