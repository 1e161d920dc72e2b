// filter.h - how far the mean of a pixel's samples is from the mean of 256, for the filters of
// shaders/filter.glsl and the workshop's grid, on a picture of slanting edges and fine lines.
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

// The root of the mean square of the difference, of 1, over 64 x 64 pixels of the picture.
//   side  samples per row and per column of a pixel, 1 to 16
// The 256 samples of the same filter form a regular grid; for the workshop's grid, those of the box
// are used.
double filter_error(enum filter_way way, int side);

#endif
