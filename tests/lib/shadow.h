// shadow.h - visible shares of a lamp that is a disc, in double precision: by brute force, and from
// the march of shaders/soft_shadow.glsl.
#ifndef TESTS_SHADOW_H
#define TESTS_SHADOW_H

#include "lib/mirror.h"

// Is there an object in a direction?
typedef bool (*shadow_blocked)(struct d3 direction, const void *data);

// The visible share of a lamp's disc: among the points of an n x n grid that lie on the disc, the
// share that nothing hides.
//   to_light  a unit vector
//   spread    radius of the disc at a distance of 1
double shadow_share(shadow_blocked blocked, const void *data, struct d3 to_light, double spread,
                    int n);

// Two directions of length 1, perpendicular to to_light and to each other.
void shadow_axes(struct d3 to_light, struct d3 *right, struct d3 *up);

// ---- The table of errors ----

// The object that may hide a part of the lamp: a half-plane, a ball or a bar.
enum shadow_obstacle { SHADOW_SHEET, SHADOW_BALL, SHADOW_BAR, SHADOW_OBSTACLES };

// The method that estimates the visible share of the lamp from one march.
enum shadow_formula {
    SHADOW_HARD,   // 0 or 1
    SHADOW_CONE,   // coneReaching of shaders/cone.glsl, from a footprint of 0.0005
    SHADOW_MOST,   // the smallest distance / t
    SHADOW_LEAST,  // pairs of steps: least of clearanceAlong in shaders/soft_shadow.glsl
    SHADOW_TWICE,  // pairs of steps, twice as hard: 1 if clear is at least 0.5
    SHADOW_SIGNED, // the smallest distance / t, with a march that continues inside the object
    SHADOW_FORMULAS
};

extern const char *const shadow_obstacle_names[SHADOW_OBSTACLES];
extern const char *const shadow_formula_names[SHADOW_FORMULAS];

// One point of a floor, under a sun that is 29 degrees high and has radius 0.04.
struct shadow_case {
    enum shadow_obstacle obstacle;
    double distance; // distance to the obstacle along the ray to the lamp's centre, scene units
    double clear; // distance from that ray to the obstacle's edge, in radii of the lamp; negative
                  // if the obstacle blocks the ray
};

// The visible share of the lamp: summed over chords of its disc for the sheet and the bar, and by
// brute force for the ball.
double shadow_truth(const struct shadow_case *scene);

// The tangent of the angle between the lamp's centre and the obstacle's edge; negative if the
// obstacle hides the centre.
double shadow_clearance(const struct shadow_case *scene);

// The visible share according to a formula.
double shadow_quick(const struct shadow_case *scene, enum shadow_formula formula);

// Find the clearance of one march with two methods. Both values are 0 if an object stops the march.
//   most   receives the smallest distance / t
//   least  receives the smallest value from pairs of steps
void shadow_march(const struct shadow_case *scene, double *most, double *least);

// How far a formula is from the truth over a range twice as wide as the penumbra: clear from -2 to
// 2, distances from 0.5 to 4.
struct shadow_error {
    // The mean of formula minus truth, the mean of its absolute value, and the largest absolute
    // value.
    double mean, mean_size, worst;
};

struct shadow_error shadow_error_of(enum shadow_obstacle obstacle, enum shadow_formula formula);

#endif
