// levels.h - the difference between a texture lookup at a level and the mean over the area that a
// pixel covers.
#ifndef TESTS_LEVELS_H
#define TESTS_LEVELS_H

#include <stdbool.h>

#include "lib/gpu.h"

enum { LEVELS_SIDE = 512 }; // side of granite.png, texels

// How tests/shaders/levels.frag reads the texture: with given sides along u and v, at a level, or
// with the footprint of a ray that meets a floor (footprintOn of shaders/texture.glsl).
enum levels_reading { LEVELS_SIDES, LEVELS_LEVEL, LEVELS_FLOOR };

// Read granite.png and load tests/shaders/levels.frag. Call this after gpu_open. Returns false
// after reporting the error.
bool levels_open(void);

// The values that the shader reads at 1024 points.
//   x, y    the two sides of the footprint in texels. For a floor, x is the ray's width in texels;
//           for a level, x is the level; y has no effect on either
//   factor  multiplies the footprint in the shader; 0 makes it almost 0
//   sine    the sine of the angle between the ray and the floor
// Returns 4 floats per point, which the caller frees. Fails the test, or ends the program, if the
// points cannot be drawn.
float *levels_read(enum levels_reading reading, double x, double y, double factor, double sine);

// The root mean square difference, in linear light, between the values that the shader reads and
// the means over rectangles of width x height texels at the same points. The means are sums over
// texels in double precision. Fails the test, or ends the program, if the points cannot be drawn.
//   factor  as for levels_read
//   sine    if below 1, the shader computes the length of the footprint on a floor; if 1, the sides
//           are passed
double levels_error(double width, double height, double factor, double sine);

#endif
