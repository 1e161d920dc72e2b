// random.h - shaders/random.glsl in C, and random numbers from rand(), which a test seeds.
#ifndef TESTS_RANDOM_H
#define TESTS_RANDOM_H

#include "lib/mirror.h"

// The value of pixelRandom(dimension) for one sample of a pixel of the picture; 0,0 is at the
// bottom left.
double random_of(int x, int y, int sample, int dimension);

// These functions return uniformly distributed values: a number in a range; a point whose
// coordinates are all in the range; and a direction of length 1.
double random_in(double low, double high);
struct d3 random_point(double low, double high);
struct d3 random_direction(void);

#endif
