// stars.h - the stars of shaders/night.glsl in double precision: the position and brightness of
// each star.
#ifndef TESTS_STARS_H
#define TESTS_STARS_H

#include "lib/mirror.h"

enum { STAR_RINGS = 64, STAR_COUNT = 8 * STAR_RINGS * STAR_RINGS };

struct star {
    struct d3 direction; // a unit vector, in the stars' frame
    double light;        // in the library's unit times steradians, for green
    double share;        // the share of the stars that are at least as bright
};

// All stars, sorted by z. Owned by the module.
const struct star *stars_all(void);

// The light that a pixel of a given width, in radians, receives from the stars in a direction: the
// sum over all stars.
double stars_light(struct d3 direction, double width);

#endif
