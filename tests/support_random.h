// support_random.h - shaders/random.glsl once more, for the tests.
#ifndef SUPPORT_RANDOM_H
#define SUPPORT_RANDOM_H

// What pixelRandom(dimension) gives in a pixel of the picture, 0,0 bottom left, for one of its
// samples.
double random_of(int x, int y, int sample, int dimension);

#endif
