// enlarge.h - a picture drawn at a lower resolution fills the window: filters that hide its pixels.
//
// Pixel p of the large picture has its centre at the place q = (p + 1/2) s - 1/2 of the small one,
// in whose units the texels' centres stand at whole numbers; s is the small size by the large. Each
// filter is a mean of the texels around q with weights that add up to 1, so an even picture stays
// as it is.
//
//   nearest    the texel whose square holds q: what the others are measured against
//   bilinear   4 texels, weights that are linear across and up: no step, but blurred
//   bicubic    16 texels, Catmull and Rom's cubic: exact for whatever is quadratic
//   edge       12 texels: a window over Lanczos' kernel, turned along the edge that runs through q,
//              longer along it and shorter across, and held between the smallest and the largest of
//              the 4 nearest texels: a sharp edge without stairs, and no ringing beside it
//
// `build/tests/measure enlarge` prints errors and costs. At half the resolution five chapters are
// off their full pictures by 11.56, 9.87, 10.08 and 9.59 of 255, in the order above, root mean
// square; the outlines and shadows of chapter 03 by 9.88, 8.20, 8.45 and 7.38. To fill 640x360 the
// filters take 0.14, 0.16, 0.35 and 0.48 of the annex scene's time on llvmpipe. So a window takes
// the edge filter, and the bilinear one where that takes too long.
//
// Sources: R. Keys, "Cubic convolution interpolation for digital image processing", IEEE Trans.
// ASSP 29, 1981; E. Catmull and R. Rom, "A class of local interpolating splines", 1974. The edge
// filter follows the idea of EASU in AMD FidelityFX Super Resolution 1.0 (T. Lottes, 2021).
#ifndef ENLARGE_H
#define ENLARGE_H

#include <stdbool.h>

#include "picture/target.h"

enum enlarge_filter {
    ENLARGE_NEAREST,
    ENLARGE_BILINEAR,
    ENLARGE_BICUBIC,
    ENLARGE_EDGE,
    ENLARGE_FILTERS
};

// One of zeros is closed. The programs are compiled when they are first asked for.
struct enlarge {
    GLuint program[ENLARGE_FILTERS], vertex_array;
    GLuint framebuffer, texture; // the small picture's copy, of 8 bits a channel
    int width, height;           // of the copy, pixels
};

// Fill what is bound for drawing with a target's picture, each value first brought into [0, 1].
//   target         of any size from 1x1 on; its texture is read
//   width, height  of what is drawn into, pixels
// Returns false, reported: the driver does not take the program.
bool enlarge_draw(struct enlarge *enlarge, const struct gl *gl, enum enlarge_filter filter,
                  const struct target *target, int width, int height);

// Free what enlarge_draw made, in the same context. One that is closed is allowed.
void enlarge_close(struct enlarge *enlarge, const struct gl *gl);

// The name of a filter, as `measure enlarge` prints it.
const char *enlarge_name(enum enlarge_filter filter);

#endif
