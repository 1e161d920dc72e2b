// checkers.h - the plane of the experiment 11_checkers in double precision: which squares a pixel
// covers, by sampling.
#ifndef TESTS_CHECKERS_H
#define TESTS_CHECKERS_H

#include "lib/gpu.h"
#include "lib/mirror.h"

// The experiment with these changes.
struct checkers_view {
    struct camera camera;
    double orthographic, turn; // the experiment's parameters; turn in degrees
};

enum { CHECKERS_WIDTH = 640, CHECKERS_HEIGHT = 360, CHECKERS_SIDE = 64 };

// One view looks across the plane to the horizon, the other looks down on it with parallel rays.
extern const struct checkers_view checkers_views[3];

// The smallest rectangle along the pattern's axes that contains what the corners of a pixel see, in
// sides of a square. Returns false if a corner does not see the plane.
bool checkers_rectangle(const struct checkers_view *view, int x, int y, double low[2],
                        double high[2]);

// The share of even squares among side x side samples of a rectangle, at the centres of its cells.
// A sample is even if both of its coordinates are even or both are odd, so counting along each axis
// is enough. An edge along an axis is off by up to 1 / (2 side), because all samples of a row fall
// on one side of it.
double checkers_of_grid(const double low[2], const double high[2], int side);

// The same with 64 x 64 samples at better positions: one in each cell of a 64 x 64 grid, and no two
// with a coordinate in common, so that an edge along an axis is off by at most 1 / 8192. The
// position of a sample in its cell is the bit reversal of the index along the other axis. So the
// samples of a row of cells are evenly spread after each half, quarter and so on, and the error at
// a corner of squares is little larger.
double checkers_of_samples(const double low[2], const double high[2]);

// The same with 64 x 64 samples of the pixel itself; no two samples of a row or column share a
// coordinate.
double checkers_of_pixel(const struct checkers_view *view, int x, int y);

// True if a ball hides the plane within two pixels.
bool checkers_hidden(const struct checkers_view *view, int x, int y);

// The shares that one of the experiment's methods shows on the GPU, for every pixel. The caller
// frees the result. NULL after reporting an error.
double *checkers_shown(const struct checkers_view *view, int way);

#endif
