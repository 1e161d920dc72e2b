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

// The bits of a lattice point.
uint32_t noise_bits(int32_t x, int32_t y, int32_t z);

// Interpolate between eight numbers: corner k is at 1 in x if k & 1, in y if k & 2, in z if k & 4.
// The sum of weight times number, as the header defines it.
struct noise noise_blend(struct d3 x, const double number[8]);

// Interpolate between eight slopes at the corners.
struct noise noise_slopes(struct d3 x, const struct d3 direction[8]);

struct noise noise_value(struct d3 p);
struct noise noise_gradient(struct d3 p);
struct noise noise_octaves(struct d3 p, int count, double gain, double lacunarity);

// The sum of ratio^i, count terms; the constant of noise_octaves.
double noise_sum(double ratio, int count);
double noise_octave_stretch(int count, double gain, double lacunarity);

#endif
