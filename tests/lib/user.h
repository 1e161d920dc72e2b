// user.h - GLFW with a test as its user: the test sets keys, pointer, sizes and the clock.
//
// This module replaces GLFW in a test program that is linked with it. There is one window at a
// time; its contents are a picture that is drawn without a display by EGL or OSMesa.
#ifndef TESTS_USER_H
#define TESTS_USER_H

#include <stdbool.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "picture/image.h"

enum { USER_HINTS = 32 };

// What the test sets, and what the program has set.
struct user {
    double now;             // time of the clock, seconds; waiting advances it
    double pixel_seconds;   // time to draw one pixel, added when the program waits for the drawing
    double pointer[2];      // position of the pointer, in units from the window's top left
    int size[2];            // size of the window, in units
    int density;            // pixels per unit: 1, or 2 as on a Mac's Retina display
    int position[2];        // position of the window on the desktop of both monitors
    bool unfocused, hidden; // the window lacks the keyboard focus; it is iconified
    void (*wait)(void);     // called at each wait for events, if not NULL
    void (*look)(void);     // called when a frame is shown, if not NULL
    const char *clipboard;  // text of the clipboard
    // Set by the program:
    bool open, ended, captured, full;
    char title[400];
    int frames, waits; // frames shown so far; waits for events so far
    int links;         // shader programs linked so far
    int objects;       // OpenGL objects made and not yet deleted: textures, programs, ...
    int cursor;        // shape of the cursor; 0 for the default
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
        GLFWdropfun drop;
    } calls;
};

extern struct user user;

// Begin with a window of 320x200 units that has had no input.
void user_reset(void);

// Press a key, release a key, or press a key and release it again.
//   modifiers  GLFW_MOD_SHIFT, GLFW_MOD_CONTROL or 0
void user_press(int key, int modifiers);
void user_release(int key);
void user_key(int key, int modifiers);

// Hold a key until the keyboard repeats it.
void user_repeat(int key, int modifiers);

// Type letters, with one event for each.
//   text  in ISO 8859-1
void user_type(const char *text);

// Move the pointer to a position; press or release a button there.
void user_point(double x, double y);
void user_button(int button, int action);

// Move the pointer to a position and click a button there once.
void user_click(double x, double y, int button);

// Move the pointer to (x, y), and drag it from there by (right, down) with the left button.
void user_drag(double x, double y, double right, double down);

// Turn the wheel by notches; away from the user is positive.
void user_wheel(double notches);

// Give the window a new size: its contents are lost, and the program is notified at once.
void user_resize(int width, int height);

// Drop a file on the window.
void user_drop(const char *path);

// Give the window the keyboard focus, or take it away; move the pointer into the window, or out of
// it.
void user_focus(bool focused);
void user_enter(bool entered);

// Read what the window shows; the caller frees image.
void user_look(struct image *image);

#endif
