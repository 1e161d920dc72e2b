// occlusion.h - the visible share of the sky, in double precision: by brute force, in closed form,
// and from the taps of shaders/occlusion.glsl.
#ifndef TESTS_OCCLUSION_H
#define TESTS_OCCLUSION_H

#include "lib/mirror.h"

// Is there an object in a direction?
typedef bool (*occlusion_blocked)(struct d3 direction, const void *data);

// The openness: among the points of an n x n grid that lie in a unit disc perpendicular to the
// normal, the share above which there is no object.
//   normal  a unit vector
double occlusion_share(occlusion_blocked blocked, const void *data, struct d3 normal, int n);

// ---- A level floor beside an object, as in the experiment 14_map ----

enum occlusion_thing {
    OCCLUSION_NOTHING,
    OCCLUSION_WALL,   // with its foot at x = 0; the floor is at x > 0
    OCCLUSION_GROOVE, // between two walls, at x = -0.6 and x = 0.6
    OCCLUSION_BAR,    // along z, with radius 0.05 and its axis above x = 0
    OCCLUSION_BALL,   // lying on the floor at x = 0
    OCCLUSION_SHAFT,  // a round well of radius x, seen from the centre of its bottom
    OCCLUSION_THINGS
};

extern const char *const occlusion_thing_names[OCCLUSION_THINGS];

struct occlusion_case {
    enum occlusion_thing thing;
    double size; // height of the walls or of the bar's axis, or radius of the ball, scene units
    double x;    // x coordinate of a point on the floor; for the shaft, the shaft's radius
};

// The distance from (x, y, 0), or for the shaft from (0, y, 0), to the union of the floor and the
// object; exact outside it.
double occlusion_distance(const struct occlusion_case *scene, double y);

// The openness at the point on the floor, by brute force with n x n points, and in closed form.
double occlusion_brute(const struct occlusion_case *scene, int n);
double occlusion_truth(const struct occlusion_case *scene);

// The openness from five taps.
double occlusion_taps(const struct occlusion_case *scene, double reach, double strength);

// ---- The table of errors ----

struct occlusion_error {
    // The mean of formula minus truth, the mean of its absolute value, and the largest absolute
    // value.
    double mean, mean_size, worst;
};

// The error over the fields of the experiment 14_map, with a reach of 1.
//   strength  0 means that nothing hides the sky
struct occlusion_error occlusion_error_of(enum occlusion_thing thing, double strength);

// The error over the pixels of chapter 14's picture that do not show the sky, drawn at 160x90 by
// tests/shaders/openness.frag.
//   formula  as in that shader
// Needs the context of gpu.h.
struct occlusion_error occlusion_scene_error(int formula);

// Print the tables that docs/14_occlusion.md quotes. Returns an exit status.
int occlusion_print(void);

#endif
