// input.h - what the hands do, gathered from GLFW's events between two frames, in their order. For
// the window alone.
#ifndef WINDOW_INPUT_H
#define WINDOW_INPUT_H

#include <stdbool.h>

#define GLFW_INCLUDE_NONE // OpenGL's names come from gl.h
#include <GLFW/glfw3.h>

#define WINDOW_INPUT_EVENTS 64 // kept between two frames; more are dropped

enum window_action {
    WINDOW_END,
    WINDOW_SCREENSHOT,
    WINDOW_FULL_SCREEN,
    WINDOW_CHOOSE, // amount: -1 the parameter before, 1 the next
    WINDOW_FOLD,   // the overlay
    WINDOW_HELP,   // all of it
    WINDOW_SIDE,   // the panel to the other side
    WINDOW_ROLL,   // the panel to its title, or back
    WINDOW_STEP,   // amount: steps on along the chosen ray
    WINDOW_FIRST,  // its first step; without one what WINDOW_RESET does
    WINDOW_LAST,   // its last step
    WINDOW_LEAVE,  // the ray
    // The pointer, with its place; hand.c says whose it is:
    WINDOW_PRESS,   // amount: 0 the left button, 1 the right one
    WINDOW_DOUBLE,  // the second of two presses that follow each other at one place
    WINDOW_TYPED,   // amount: a letter's code, or WINDOW_TYPED_ENTER, ..., while typing or picking
    WINDOW_RELEASE, // amount: 1 a click, 0 the end of a drag, or the window lost the focus
    // What changes the picture:
    WINDOW_PAUSE,   // as time went on until now
    WINDOW_RESTART, // the time
    WINDOW_BEGIN,   // the time and the camera
    WINDOW_ORTHOGRAPHIC,
    WINDOW_CHANGE, // amount: key presses
    WINDOW_RESET,
    WINDOW_VIEW, // amount: enum shader_view
    // What goes on: events of a kind that follow each other are one, their ways added up.
    WINDOW_ZOOM,   // way: notches of the wheel, away from the person positive; place
    WINDOW_LOOK,   // way: pixels that the captured pointer went right and down
    WINDOW_TRAVEL, // way: seconds of movement right, up, forward; more where faster is held
    WINDOW_DRAG,   // way: pixels that the pointer went right and down with a button held; place
    WINDOW_POINT   // the pointer is there: no button, or not far enough for a drag
};

enum { WINDOW_TYPED_BACK = 8, WINDOW_TYPED_ENTER = 13, WINDOW_TYPED_ESCAPE = 27 };

struct window_event {
    enum window_action action;
    int amount;
    double way[3];
    double place[2]; // of the pointer, in the window's units from its top left; -1,-1: elsewhere
};

// Keys that act as long as they are held.
enum window_key {
    WINDOW_KEY_LEFT,
    WINDOW_KEY_RIGHT,
    WINDOW_KEY_UP,
    WINDOW_KEY_DOWN,
    WINDOW_KEY_DOWN_TOO,
    WINDOW_KEY_FORWARD,
    WINDOW_KEY_BACK,
    WINDOW_KEY_FASTER,
    WINDOW_KEY_FASTER_TOO, // five presses of Shift are a wish of their own on Windows
    WINDOW_KEY_COUNT
};

enum window_pointer { WINDOW_POINTER_FREE, WINDOW_POINTER_PRESSED, WINDOW_POINTER_DRAGS };

struct window_input {
    GLFWwindow *window;
    // Called, where it is not NULL, as soon as the window must be drawn again: a hand that resizes
    // it may keep GLFW from returning.
    void (*show)(void *to);
    void *to; // its argument
    // Since the last window_input_forget:
    struct window_event event[WINDOW_INPUT_EVENTS];
    int events;
    bool damaged; // the window must be drawn again
    // Kept from frame to frame:
    bool typing;  // keys are letters; others set it
    bool picking; // a colour's picker is open, which Escape closes; others set it
    bool held[WINDOW_KEY_COUNT];
    double counted; // all movement up to this time of glfwGetTime is in the events
    enum window_pointer state;
    int button; // that is held: 0 left, 1 right
    struct {
        double at, place[2]; // when and where the left button was pressed last
    } press;
    bool captured;
    bool jumped;       // the next position of the pointer is no movement
    double pointer[2]; // where it was last
    bool seen;         // at is known
    double at[2];      // where it is
};

// Receive the events of a window from now on.
//   input  must outlive the window's last event
//   show   NULL, or called with its argument
void window_input_open(struct window_input *input, GLFWwindow *window, void (*show)(void *to),
                       void *to);

// Count the movement up to now. To be called before the events are read.
void window_input_count(struct window_input *input);

// Start the next frame: what was gathered is forgotten; held keys stay held.
void window_input_forget(struct window_input *input);

// True while a key is held that moves the camera.
bool window_input_moves(const struct window_input *input);

#endif
