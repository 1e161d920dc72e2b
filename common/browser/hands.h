// hands.h - what a page's script tells the window of: glfw.c hands it on to the harness.
#ifndef HANDS_H
#define HANDS_H

// The canvas was laid out anew.
//   width, height  in the page's units
//   across, down   of its drawing buffer, pixels
void live_size(int width, int height, int across, int down);

// A key by GLFW's number and action: the page maps positions, and keeps those that are its own.
void live_key(int key, int action, int modifiers);

// A character was typed, by its code.
void live_type(unsigned code);

// The pointer's place in the page's units from the canvas's top left.
void live_pointer(double x, double y);

// A button of the mouse by GLFW's number.
void live_button(int button, int pressed, int modifiers);

// Notches of the wheel, away from the hand positive.
void live_wheel(double notches);

void live_focus(int focused);

// While the page or the canvas cannot be seen the program's clock stands still.
void live_hide(int hidden);

// True where float targets do not blend and are made of half floats.
int live_halves(void);

#endif
