// page.h - what a page does for its program: page.js, which Emscripten links in.
#ifndef PAGE_H
#define PAGE_H

enum { PAGE_CONTEXT, PAGE_NO_WEBGL, PAGE_NO_FLOATS };

// Create a WebGL 2 context of the page's canvas, without alpha, antialiasing and depth, and make it
// current. Returns PAGE_CONTEXT, or what is missing: WebGL 2, or float targets.
int page_open_context(void);

void page_close_context(void);

// True if float targets blend: EXT_float_blend.
int page_blends_floats(void);

// True if the driver may compile on threads of its own: KHR_parallel_shader_compile.
int page_has_threads(void);

// The size that a command line asks for, pixels.
void page_size(int width, int height);

void page_title(const char *text);

// The label of a key on the reader's keyboard, in UTF-8; "" if the browser does not provide it.
//   key  GLFW's key
void page_key_label(int key, char *label, int size);

// Capture the pointer, or release it.
void page_capture(int captured);

// Set the pointer's shape, one of GLFW's; 0 for the arrow.
void page_cursor(int shape);

// Give the page a picture, which the browser writes as PNG.
//   pixel  3 bytes per pixel, row 0 at the top
//   name   of the file
void page_picture(const unsigned char *pixel, int width, int height, const char *name);

#endif
