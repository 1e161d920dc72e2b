// canvas.h - the canvas's size and input. The page's script calls these functions, and glfw.c
// passes the size and the input on to the harness.
#ifndef CANVAS_H
#define CANVAS_H

// The canvas has changed size.
//   width, height  size in CSS pixels
//   across, down   size of the drawing buffer in pixels
void live_size(int width, int height, int across, int down);

// A key was pressed, repeated or released. The page maps the position of the key to GLFW's key
// code, and does not pass on the keys that are left to the browser, such as Tab.
void live_key(int key, int action, int modifiers);

// A character was typed, given as its Unicode code point.
void live_type(unsigned code);

// The pointer has moved to a position, in CSS pixels from the canvas's top left corner. While the
// pointer is captured, the origin is arbitrary.
void live_pointer(double x, double y);

// A mouse button was pressed or released.
//   button  GLFW's number for the button
void live_button(int button, int pressed, int modifiers);

// The wheel was turned by this many notches, which may be a fraction. Positive is away from the
// user.
void live_wheel(double notches);

void live_focus(int focused);

// The page or the canvas was hidden or shown. While either is hidden, the program's clock is
// stopped.
void live_hide(int hidden);

#endif
