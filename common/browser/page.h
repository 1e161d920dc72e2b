// page.h - what a page does for the program in it: page.js, linked in by Emscripten.
#ifndef PAGE_H
#define PAGE_H

enum { PAGE_CONTEXT, PAGE_NO_WEBGL, PAGE_NO_FLOATS };

// Make a WebGL 2 context of the page's canvas and make it current: no alpha, no antialiasing, no
// depth. Returns PAGE_CONTEXT, or what is missing: WebGL 2, or float targets.
int page_open_context(void);

void page_close_context(void);

// True when float targets blend: EXT_float_blend.
int page_blends_floats(void);

// The picture that a command line asks for: its sides, pixels.
void page_size(int width, int height);

void page_title(const char *text);

// The label that the reader's keyboard has on a key, in UTF-8; "" where the browser does not say.
//   key  GLFW's number
void page_key_label(int key, char *label, int size);

// Hold the pointer, or let it go.
void page_capture(int captured);

// The pointer's shape, one of GLFW's; 0 for the arrow.
void page_cursor(int shape);

// Take over a picture, which the browser writes as PNG.
//   pixel  3 bytes a pixel, row 0 on top
//   name   of the file
void page_picture(const unsigned char *pixel, int width, int height, const char *name);

#endif
