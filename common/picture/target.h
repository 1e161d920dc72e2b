// target.h - a float texture to draw into.
#ifndef TARGET_H
#define TARGET_H

#include <stdbool.h>

#include "context/gl.h"

// Red, green, blue and alpha, a float each. Made by the first target_bind that asks for a size.
struct target {
    GLuint framebuffer, texture;
    GLenum form;
    int width, height; // pixels; 0 before the first target_bind
};

// The text of a vertex shader: three vertices of no buffer, a triangle that covers whatever is
// drawn into.
extern const char target_vertex[];

// The form of targets in which what is drawn adds up: GL_RGBA32F, as OpenGL 3.3 asks of every
// driver; GL_RGBA16F where that does not blend.
GLenum target_form(const struct gl *gl);

// Make the names of a target that has no pixels yet, and give them back.
//   form  GL_RGBA32F or GL_RGBA16F
void target_open(struct target *target, const struct gl *gl, GLenum form);
void target_close(struct target *target, const struct gl *gl);

// Bind a target to draw into, made anew when its size changes: then its pixels are undefined.
// Returns false, reported: the driver has no float target, or none of that size.
bool target_bind(struct target *target, const struct gl *gl, int width, int height);

// Read a target: 4 floats a pixel, bottom row first. It stays bound for reading.
//   values  room for 4 * width * height floats, the caller's
void target_read(const struct target *target, const struct gl *gl, float *values);

#endif
