// solid.h - for tests of solids: a surface made of pieces, and the comparison of a solid's
// distances in tests/shaders/solids.frag with those to the nearest point of the surface, found in
// double precision.
#ifndef TESTS_SOLID_H
#define TESTS_SOLID_H

#include <stdbool.h>

#include "lib/mirror.h"

// The functions of the shader. The shader evaluates each function at SOLID_ITEMS pairs of points,
// which are close together or far apart.
enum {
    CYLINDER,
    HEX_PRISM,
    CAPPED_CONE,
    CAPSULE,
    EXTRUDED_RING,
    EXTRUDED_ELBOW,
    TURNED_DISC,
    TURNED_RECTANGLE,
    TURNED_BOWL,
    TURNED_CIRCLE,
    TORUS,
    TWISTED
};
enum { SOLID_ITEMS = 2048, SOLID_SLOTS = 2, SOLID_GRID = 24, SOLID_MOST = 16 };

// A piece of a surface: a parallelogram origin + u side + v other, with u and v in [0, 1]; or, if
// turned, a segment or an arc of the half-plane x >= 0, rotated about the y axis. u then runs along
// the segment or the arc, and v runs once around the axis.
struct patch {
    bool turned, arc;
    struct d3 origin, side, other;          // of a parallelogram
    double from[2], to[2];                  // of a segment: its ends
    double centre[2], radius;               // of an arc, from angle from[0] to angle to[0]
    struct d3 grid[SOLID_GRID][SOLID_GRID]; // points of the piece
};

// A solid: its surface, and its interior.
struct solid {
    const char *name;
    int function;
    float number[4];
    double thickness; // if > 0, the surface is a sheet, thickened by this much on either side
    bool (*inside)(const struct solid *solid, struct d3 p);
    bool exact_outside, exact_inside;
    int count;
    struct patch patch[SOLID_MOST];
};

struct tally {
    int inside, outside;
    double worst;    // the largest |f - truth| where f is exact, in units of the slack
    double least[2]; // the smallest f / truth: inside, outside
    double steepest; // the largest |f(p) - f(q)| / |p - q|
};

// Each of these functions adds a piece to a surface: a parallelogram; a rotated segment of the
// half-plane x >= 0; or the part with x >= 0 of a circle around (x, 0), rotated.
void solid_add_flat(struct solid *solid, struct d3 origin, struct d3 side, struct d3 other);
void solid_add_turned(struct solid *solid, double x0, double y0, double x1, double y1);
void solid_add_turned_circle(struct solid *solid, double x, double radius);

// The shader's values: for each of SOLID_ITEMS items, SOLID_SLOTS points with their distances. The
// caller frees the values.
float *solid_call(const struct solid *solid);

// The allowed error of a distance: a few roundings of numbers no larger than the point and the
// solid, plus the remaining error of the search.
double solid_slack(struct d3 p);

// Always false, because a sheet has no inside.
bool solid_never(const struct solid *solid, struct d3 p);

// Compare the shader's distances with the surface. At each point, the value must be a lower bound
// on either side, with a slope of at most 1, and exact where the solid says so. Prints the
// differences, and fails the test if a value is wrong.
struct tally solid_check(struct solid *solid);

#endif
