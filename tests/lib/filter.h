// filter.h - how far the mean of a pixel's samples is from the mean of 256 samples, for the filters
// of shaders/filter.glsl and the grid of Electric Square's workshop, in a picture of slanting edges
// and fine lines.
#ifndef TESTS_FILTER_H
#define TESTS_FILTER_H

#include <stdbool.h>

// Ways to place n x n samples. The workshop's samples are at (i, j) / n from the pixel's centre.
enum filter_way {
    FILTER_BOX,
    FILTER_BOX_JITTERED,
    FILTER_TENT,
    FILTER_TENT_JITTERED,
    FILTER_GAUSSIAN,
    FILTER_GAUSSIAN_JITTERED,
    FILTER_WORKSHOP,
    FILTER_WAYS
};

extern const char *const filter_way_names[FILTER_WAYS];

// The root mean square difference from the mean of 256 samples, over 64 x 64 pixels of the picture.
// White is 1.
//   side  samples per row and per column of a pixel, 1 to 16
// The 256 samples are those of the same filter in a regular grid; the workshop's grid is compared
// with those of the box filter.
double filter_error(enum filter_way way, int side);

#endif
