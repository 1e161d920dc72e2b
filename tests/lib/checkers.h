// checkers.h - the plane of the experiment 11_checkers in double precision: samples of the squares
// that a pixel covers.
#ifndef TESTS_CHECKERS_H
#define TESTS_CHECKERS_H

#include "lib/gpu.h"
#include "lib/mirror.h"

// A camera and values of the experiment's parameters.
struct checkers_view {
    struct camera camera;
    double orthographic, turn; // turn is in degrees
};

enum { CHECKERS_WIDTH = 640, CHECKERS_HEIGHT = 360, CHECKERS_SIDE = 64 };

// The first view looks across the plane to the horizon, the second looks down on it with parallel
// rays, and the third is halfway between a perspective and a parallel view.
extern const struct checkers_view checkers_views[3];

// Find the smallest rectangle along the pattern's axes that contains the points seen at the corners
// of a pixel. The unit is the side of a square. Returns false if the ray through a corner misses
// the plane.
bool checkers_rectangle(const struct checkers_view *view, int x, int y, double low[2],
                        double high[2]);

// The share of even squares in a rectangle, from samples at the centres of side x side cells. A
// square is even if both of its indices are even or both are odd, so counting along each axis is
// enough. An edge parallel to an axis is off by up to 1 / (2 side), because all samples of a row
// parallel to the edge are on the same side of it.
double checkers_of_grid(const double low[2], const double high[2], int side);

// The share of even squares from 64 x 64 samples at better positions: one in each cell of a 64 x 64
// grid, and no two with a coordinate in common, so an edge parallel to an axis is off by at most
// 1/8192. The position of a sample in its cell along one axis is the bit reversal of the cell's
// index along the other axis. The samples in each half, quarter and so on of a row of cells are
// therefore evenly spread, and the error at a corner of squares is only slightly larger.
double checkers_of_samples(const double low[2], const double high[2]);

// The share of even squares from 64 x 64 samples of the pixel itself, not of its rectangle. No two
// samples share a coordinate.
double checkers_of_pixel(const struct checkers_view *view, int x, int y);

// True if a ball hides the plane within two pixels of this pixel's centre.
bool checkers_hidden(const struct checkers_view *view, int x, int y);

// The shares that one of the experiment's methods shows on the GPU, for every pixel. The caller
// frees the result, which is NULL if there is no memory. Fails the test, or ends the program, if
// the picture cannot be drawn.
//   way  the method: the value of the experiment's parameter `way`
double *checkers_shown(const struct checkers_view *view, int way);

#endif
