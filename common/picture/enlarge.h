// enlarge.h - filters that enlarge a picture of lower resolution to fill the window, without
// visible pixels.
//
// Pixel p of the large picture has its centre at q = (p + 1/2) s - 1/2 in the small picture, where
// the texels' centres have integer coordinates; s is the small size divided by the large size. Both
// filters are weighted means of the texels around q, with weights that add up to 1, so a uniform
// picture does not change.
//
//   bilinear   uses 4 texels, with weights that are linear in x and y. There are no blocks, but the
//              picture is blurred
//   edge       uses 12 texels, with a Lanczos kernel that is turned along the edge through q,
//              longer along the edge and shorter across it. The result is limited to the range of
//              the 4 nearest texels. Edges are sharp, without stairs and without ringing beside
//              them
//
// `build/tests/measure enlarge` prints errors and costs. At half the resolution, five chapters
// differ from their pictures at full resolution by 9.87 (bilinear) and 9.59 (edge) of 255, root
// mean square; the outlines and shadows of chapter 03 differ by 8.20 and 7.38. At a quarter, the
// outlines of chapter 21 have visible stairs with the bilinear filter. To fill 640x360 pixels on
// llvmpipe, the filters take 0.16 and 0.48 of the time that drawing
// tests/pictures/reference_scene.frag takes. So a window uses the edge filter, and the bilinear
// filter where the edge filter would take too long.
//
// Source: the edge filter follows the idea of EASU in AMD FidelityFX Super Resolution 1.0 (T.
// Lottes, 2021).
#ifndef ENLARGE_H
#define ENLARGE_H

#include <stdbool.h>

#include "picture/target.h"

enum enlarge_filter { ENLARGE_BILINEAR, ENLARGE_EDGE, ENLARGE_FILTERS };

// A zero-initialised struct is closed. A program is linked when it is first needed.
struct enlarge {
    GLuint program[ENLARGE_FILTERS], vertex_array;
    GLint step[ENLARGE_FILTERS]; // location of the uniform step
    struct target copy;          // copy of the small picture, 8 bits per channel
};

// Fill the framebuffer that is bound for drawing with a target's picture, clamped to [0, 1].
//   target         the small picture, of any size
//   width, height  size of the framebuffer, pixels
// Returns false after reporting the error if the driver rejects the program or cannot create a
// target for a copy of the picture.
bool enlarge_draw(struct enlarge *enlarge, const struct gl *gl, enum enlarge_filter filter,
                  const struct target *target, int width, int height);

// Free everything, in the same context. A zero-initialised struct is allowed.
void enlarge_close(struct enlarge *enlarge, const struct gl *gl);

// Return the name of a filter, as `measure enlarge` prints it.
const char *enlarge_name(enum enlarge_filter filter);

#endif
