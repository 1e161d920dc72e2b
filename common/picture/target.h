// target.h - a float texture to draw into.
#ifndef TARGET_H
#define TARGET_H

#include <stdbool.h>

#include "context/gl.h"

// Red, green, blue and alpha, a float each. Made by the first target_bind that asks for a size.
struct target {
    GLuint framebuffer, texture;
    int width, height; // pixels; 0 before the first target_bind
};

// Make the names of a target that has no pixels yet, and give them back.
void target_open(struct target *target, const struct gl *gl);
void target_close(struct target *target, const struct gl *gl);

// Bind a target to draw into, made anew when its size changes: then its pixels are undefined.
// Returns false, reported: the driver has no float target, or none of that size.
bool target_bind(struct target *target, const struct gl *gl, int width, int height);

// Read a target: 4 floats a pixel, bottom row first. It stays bound for reading.
//   values  room for 4 * width * height floats, the caller's
void target_read(const struct target *target, const struct gl *gl, float *values);

#endif
