// user.h - GLFW whose user is a test: keys, pointer, sizes and the clock are what the test says.
//
// It takes GLFW's place in a test program that is linked with it. One window at a time; what it
// shows is a picture of its own, drawn without a display by EGL or OSMesa.
#ifndef TESTS_USER_H
#define TESTS_USER_H

#include <stdbool.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "picture/image.h"

enum { USER_HINTS = 32 };

// What the test sets, and what the program has set.
struct user {
    double now;             // of the clock, seconds; a wait moves it on
    double pixel_seconds;   // that drawing a pixel takes, when the program waits for the drawing
    double pointer[2];      // where it is, in the window's units from its top left
    int size[2];            // of the window, in its units
    int density;            // pixels of a unit: 1, or 2 as on a Mac's Retina display
    int place[2];           // of the window on its monitor
    bool unfocused, hidden; // it has no keyboard; it is iconified
    void (*wait)(void);     // called at each wait for events, if it is not NULL
    // What the program asked for:
    bool open, ended, captured, full;
    char title[400];
    int frames, waits; // shown so far; waited for events so far
    int cursor;        // its shape, 0: the arrow
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

// Begin with a window of zeros, 320x200 units, that nobody has touched.
void user_reset(void);

// A key goes down, or up; a key is pressed and let go.
//   modifiers  GLFW_MOD_SHIFT or 0
void user_press(int key, int modifiers);
void user_release(int key);
void user_key(int key, int modifiers);

// Letters arrive, one event each.
//   text  ISO 8859-1
void user_type(const char *text);

// The pointer goes to a place; a button goes down, or up, where it is.
void user_point(double x, double y);
void user_button(int button, int action);

// The pointer goes to a place and presses a button, once.
void user_click(double x, double y, int button);

// The pointer goes to a place, and on from there with the left button held.
void user_drag(double x, double y, double right, double down);

// The wheel turns by notches, away from the user positive.
void user_wheel(double notches);

// The window gets another size: its content is lost, and the program hears of that at once.
void user_resize(int width, int height);

// Read what the window shows; the caller frees image.
void user_look(struct image *image);

#endif
