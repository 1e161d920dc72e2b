// target.h - a texture to draw into, and the small programs and textures of the harness itself.
#ifndef TARGET_H
#define TARGET_H

#include <stdbool.h>

#include "context/gl.h"

// A framebuffer with one texture of red, green, blue and alpha. target_bind allocates the pixels.
struct target {
    GLuint framebuffer, texture;
    GLenum format;
    int width, height; // pixels; 0 before the first target_bind
};

// Link a program of the harness itself.
//   what  the program's name in the error message
// Reports an error and returns 0 if the driver rejects the program.
GLuint target_program(const struct gl *gl, const char *what, const char *vertex,
                      const char *fragment);

// Fill the bound texture with an image of one byte per pixel.
void target_upload(const struct gl *gl, int width, int height, const unsigned char *pixel);

// A vertex shader that needs no buffer: its three vertices form a triangle that covers the target.
extern const char target_vertex[];

// Return the format for targets: GL_RGBA32F, into which OpenGL 3.3 requires every driver to draw
// and to blend, or GL_RGBA16F if this driver cannot.
//   blends  the targets are drawn into with blending
GLenum target_format(const struct gl *gl, bool blends);

// Choose how a target's texture is read; without this call, the nearest texel is read.
//   filter  'n' the nearest texel, 'm' from mip levels, otherwise linear, if the driver can filter
//           the target's format
//   repeat  the picture repeats; otherwise, its edge is continued
void target_filter(const struct target *target, const struct gl *gl, char filter, bool repeat);

// Open a target without pixels, and close it.
//   format  GL_RGBA32F, GL_RGBA16F or GL_RGBA8
void target_open(struct target *target, const struct gl *gl, GLenum format);
void target_close(struct target *target, const struct gl *gl);

// Do the same as target_bind without reporting an error.
bool target_make(struct target *target, const struct gl *gl, int width, int height);

// Bind a target to draw into. If its size changes, its pixels are undefined.
// Returns false after reporting the error if the driver cannot create a target of this format and
// size.
bool target_bind(struct target *target, const struct gl *gl, int width, int height);

// Read a target: 4 floats per pixel, bottom row first. The target stays bound for reading.
//   values  room for 4 * width * height floats
void target_read(const struct target *target, const struct gl *gl, float *values);

#endif
