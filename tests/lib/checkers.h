// checkers.h - the plane of the experiment 11_checkers in double precision: what a pixel
// sees of its squares, by samples.
#ifndef TESTS_CHECKERS_H
#define TESTS_CHECKERS_H

#include "lib/gpu.h"
#include "lib/mirror.h"

// The experiment as it stands, but for these.
struct checkers_view {
    struct camera camera;
    double orthographic, turn; // as its parameters; turn in degrees
};

enum { CHECKERS_WIDTH = 640, CHECKERS_HEIGHT = 360, CHECKERS_SIDE = 64 };

// A view that looks over the plane to the horizon, and one that looks down on it by parallel rays.
extern const struct checkers_view checkers_views[3];

// The smallest rectangle along the pattern's axes that holds what the corners of a pixel see, in
// sides of a square: false where a corner sees no plane.
bool checkers_rectangle(const struct checkers_view *view, int x, int y, double low[2],
                        double high[2]);

// The share of even squares among side x side samples of a rectangle, the middles of its cells. A
// sample is even where both its coordinates are, or neither; so counting along each axis is enough.
// An edge along an axis is off by up to 1 / (2 side): the samples of a whole row fall on one side.
double checkers_of_grid(const double low[2], const double high[2], int side);

// The same among 64 x 64 samples that are better placed: one in each cell of a 64 x 64 grid, and no
// two with a coordinate in common, so that an edge along an axis is off by at most 1 / 8192. Where
// in its cell a sample stands, is the bits of the other axis' number in reversed order; so the
// samples of a row of cells are even after each of its halves, quarters and so on, and a corner of
// squares is off by little more.
double checkers_of_samples(const double low[2], const double high[2]);

// The same among 64 x 64 samples of the pixel itself; no two of a row or column of them share a
// coordinate.
double checkers_of_pixel(const struct checkers_view *view, int x, int y);

// True where a ball hides the plane within two pixels.
bool checkers_hidden(const struct checkers_view *view, int x, int y);

// The shares that the GPU shows by one of the experiment's ways, for every pixel; the caller frees.
// NULL, reported.
double *checkers_shown(const struct checkers_view *view, int way);

#endif
