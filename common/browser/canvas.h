// canvas.h - the canvas's size and input. The page's script calls these functions, and glfw.c
// passes the values on to the harness.
#ifndef CANVAS_H
#define CANVAS_H

// The canvas has changed size.
//   width, height  size in the page's units
//   across, down   size of the drawing buffer in pixels
void live_size(int width, int height, int across, int down);

// A key was pressed, repeated or released. The page maps the positions of keys to GLFW's keys,
// and does not pass on the keys that it uses itself.
void live_key(int key, int action, int modifiers);

// A character was typed.
void live_type(unsigned code);

// The pointer has moved to a position, in the page's units from the canvas's top left.
void live_pointer(double x, double y);

// A mouse button was pressed or released.
//   button  GLFW's number
void live_button(int button, int pressed, int modifiers);

// The wheel was turned by some notches, positive away from the user.
void live_wheel(double notches);

void live_focus(int focused);

// The page or the canvas was hidden or shown. While either is hidden, the program's clock is
// stopped.
void live_hide(int hidden);

// True if float targets do not blend, so that half floats are used.
int live_halves(void);

#endif
