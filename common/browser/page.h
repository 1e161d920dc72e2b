// page.h - functions of the page that its program calls, implemented in page.js.
#ifndef PAGE_H
#define PAGE_H

enum { PAGE_CONTEXT, PAGE_NO_WEBGL, PAGE_NO_FLOATS };

// Create a WebGL 2 context for the page's canvas, without alpha, antialiasing or depth, and make it
// current. Returns PAGE_CONTEXT on success, PAGE_NO_WEBGL if WebGL 2 is missing, or PAGE_NO_FLOATS
// if float targets are missing.
int page_open_context(void);

void page_close_context(void);

// Copy a rectangle of the bound target to one of the canvas if the driver has only half floats,
// from which WebGL cannot blit to the canvas. Returns 0 if it can.
//   from, to  left, bottom, right, top
int page_draws_copy(const int from[4], const int to[4], int filter);

// True if the driver may compile on separate threads (KHR_parallel_shader_compile).
int page_has_threads(void);

// Tell the page the size that the command line asks for, in pixels.
void page_size(int width, int height);

void page_title(const char *text);

// Find the label of a key on the user's keyboard.
//   key    GLFW's key code
//   label  receives the label in UTF-8, at most size bytes; "" if the browser does not provide it
void page_key_label(int key, char *label, int size);

// Capture the pointer, or release it.
void page_capture(int captured);

// Set the pointer's shape to one of GLFW's standard shapes, or to the arrow if shape is 0.
void page_cursor(int shape);

// Give the page a picture, which the browser writes as PNG.
//   pixel  3 bytes per pixel, row 0 at the top
//   name   name of the file
void page_picture(const unsigned char *pixel, int width, int height, const char *name);

#endif
