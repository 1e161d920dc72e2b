// paint.h - drawing functions for the textures: a function of a point becomes a picture that
// repeats without a seam, written as PNG to standard output.
//
// A texture is the same on every machine, to the last bit of each pixel: random numbers come from
// an integer hash, and real arithmetic uses only + - * / sqrt and floor, whose results IEEE 754
// defines to the last bit. sin, pow and exp are not used, because their last bit depends on the
// library.
//
// u runs to the right and v upwards, both from 0 to 1; every pattern here has the period 1 in both.
#ifndef PAINT_H
#define PAINT_H

#include <stdint.h>

// ---- The picture ----

enum paint_kind {
    PAINT_COLOUR,  // three numbers, linear light in [0, 1]; stored as sRGB
    PAINT_NUMBER,  // one number in [0, 1]; stored unchanged
    PAINT_NUMBERS, // three numbers in [0, 1]; stored unchanged
    PAINT_FOUR,    // a colour and a fourth number, which is stored unchanged
    PAINT_BYTES    // four numbers in [0, 1]; stored unchanged
};

// Draw a texture and write it. The file's top row is v = 1.
//   samples  samples x samples points of a pixel are averaged
//   at       the texture: fills in value at a point, with as many numbers as its kind has
// Returns the program's exit status.
int paint_texture(int width, int height, int samples, enum paint_kind kind,
                  void (*at)(double u, double v, double *value));

// ---- Chance ----

// 32 bits that depend on all bits of two integers and of a seed.
uint32_t paint_hash(int i, int j, uint32_t seed);

// The bits of paint_hash as a number in [0, 1), a multiple of 2^-32.
double paint_random(int i, int j, uint32_t seed);

// ---- Real arithmetic ----

// The exponential of x, using only + - * / and floor, so it is the same everywhere: 2^n times a
// series for the rest. The relative error is at most 1e-14 if |x| <= 700. Below -700 the result is
// 0, above 700 it is that for 700.
double paint_exp(double x);

// ---- Patterns ----

// A smooth step from 0 to 1 as x goes from a to b, with slope and curvature 0 at both ends.
double paint_step(double a, double b, double x);

// Value noise in [0, 1): random numbers at the corners of columns x rows cells per period,
// interpolated with paint_step.
double paint_noise(double u, double v, int columns, int rows, uint32_t seed);

// A sum of octaves of paint_noise, each twice as fine and half as strong as the octave before,
// divided by the sum of the strengths; the result is in [0, 1).
double paint_octaves(double u, double v, int columns, int rows, int octaves, uint32_t seed);

// The grain that contains a point, of columns x rows grains per period. Each grain has a centre at
// a random position in its cell, and a size. A point belongs to the grain for which the distance to
// the centre minus the size is least.
struct paint_grain {
    uint32_t name; // a hash of the grain, which determines its material
    double edge;   // how far the point is inside the grain, in cells; 0 at the border
    double u, v;   // from the grain's centre to the point, in cells
};
struct paint_grain paint_grain(double u, double v, int columns, int rows, uint32_t seed);

// ---- Colour ----

// The linear light of an sRGB colour 0xRRGGBB, as shown by a colour picker.
void paint_colour(uint32_t code, double value[3]);

// The byte that stores a light as sRGB: the byte nearest to 255 times the light's sRGB value. Light
// outside [0, 1] becomes 0 or 255.
unsigned char paint_byte(double light);

// The inverse of paint_byte: the light that a byte stores.
double paint_light(int byte);

// The colour at x in [0, 1] of a scale of count colours 0xRRGGBB at equal steps, interpolated
// linearly in linear light.
void paint_scale(int count, const uint32_t *code, double x, double value[3]);

#endif
