// user.h - GLFW with a test as its user: keys, pointer, sizes and the clock are what the test sets.
//
// It replaces GLFW in a test program that is linked with it. There is one window at a time; its
// contents are a picture that is drawn without a display by EGL or OSMesa.
#ifndef TESTS_USER_H
#define TESTS_USER_H

#include <stdbool.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "picture/image.h"

enum { USER_HINTS = 32 };

// What the test sets, and what the program has set.
struct user {
    double now;             // of the clock, seconds; waiting advances it
    double pixel_seconds;   // time to draw one pixel, when the program waits for the drawing
    double pointer[2];      // its position, in the window's units from its top left
    int size[2];            // of the window, in its units
    int density;            // pixels per unit: 1, or 2 as on a Mac's Retina display
    int place[2];           // of the window on its monitor
    bool unfocused, hidden; // there is no keyboard; the window is iconified
    void (*wait)(void);     // called at each wait for events, if not NULL
    const char *clipboard;  // its text
    // What the program asked for:
    bool open, ended, captured, full;
    char title[400];
    int frames, waits; // shown so far; waited for events so far
    int links;         // programs linked so far
    int cursor;        // its shape; 0 for the arrow
    int hint[USER_HINTS][2], hints;
    struct {
        void *pointer;
        GLFWkeyfun key;
        GLFWcharfun letter;
        GLFWmousebuttonfun button;
        GLFWcursorposfun pointed;
        GLFWcursorenterfun entered;
        GLFWscrollfun wheel;
        GLFWwindowfocusfun focus;
        GLFWwindowrefreshfun damage;
    } calls;
};

extern struct user user;

// Begin with a black window of 320x200 units that nobody has touched.
void user_reset(void);

// Press or release a key; press it and release it again.
//   modifiers  GLFW_MOD_SHIFT or 0
void user_press(int key, int modifiers);
void user_release(int key);
void user_key(int key, int modifiers);

// Type letters, one event each.
//   text  ISO 8859-1
void user_type(const char *text);

// Move the pointer to a position; press or release a button there.
void user_point(double x, double y);
void user_button(int button, int action);

// Move the pointer to a position and click a button there once.
void user_click(double x, double y, int button);

// Move the pointer to a position, and from there with the left button held.
void user_drag(double x, double y, double right, double down);

// Turn the wheel by notches; away from the user is positive.
void user_wheel(double notches);

// Give the window a new size: its content is lost, and the program is told at once.
void user_resize(int width, int height);

// Read what the window shows; the caller frees image.
void user_look(struct image *image);

#endif
