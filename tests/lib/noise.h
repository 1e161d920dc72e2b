// noise.h - shaders/noise.glsl in double precision.
#ifndef TESTS_NOISE_H
#define TESTS_NOISE_H

#include <stdint.h>

#include "lib/mirror.h"

// A value and its gradient.
struct noise {
    double value;
    struct d3 gradient;
};

// The fade from 0 to 1 and its slope.
double noise_fade(double x);
double noise_slope(double x);

// The random bits of a lattice point.
uint32_t noise_bits(int32_t x, int32_t y, int32_t z);

// Interpolate between eight numbers at the corners of a unit cube: the result is the sum of weight
// times number. Corner k is at x = 1 if k & 1, at y = 1 if k & 2, and at z = 1 if k & 4.
struct noise noise_blend(struct d3 x, const double number[8]);

// Interpolate between eight linear functions. Function k is 0 at corner k and has the gradient
// direction[k].
struct noise noise_slopes(struct d3 x, const struct d3 direction[8]);

struct noise noise_value(struct d3 p);
struct noise noise_gradient(struct d3 p);
struct noise noise_octaves(struct d3 p, int count, double gain, double lacunarity);

// The sum of ratio^i over count terms, from i = 0; and the Lipschitz constant of noise_octaves, as
// octaveStretch of shaders/noise.glsl computes it.
double noise_sum(double ratio, int count);
double noise_octave_stretch(int count, double gain, double lacunarity);

#endif
