// occlusion.h - the share of the sky that is seen, in double precision: by brute force, in
// closed form, and by the taps of shaders/occlusion.glsl.
#ifndef TESTS_OCCLUSION_H
#define TESTS_OCCLUSION_H

#include "lib/mirror.h"

// Does something stand in a direction?
typedef bool (*occlusion_blocked)(struct d3 direction, const void *data);

// The openness: of the points of a disc across the normal, n x n in the square round it, the share
// above which nothing stands.
//   normal  length 1
double occlusion_share(occlusion_blocked blocked, const void *data, struct d3 normal, int n);

// ---- A level floor beside something, as in the experiment 14_map ----

enum occlusion_thing {
    OCCLUSION_NOTHING,
    OCCLUSION_WALL,   // its foot at x = 0, the floor at x > 0
    OCCLUSION_GROOVE, // between two walls, at -0.6 and 0.6
    OCCLUSION_BAR,    // along z, of radius 0.05, its middle over x = 0
    OCCLUSION_BALL,   // lying on the floor at x = 0
    OCCLUSION_SHAFT,  // a round well of radius x, seen from the middle of its bottom
    OCCLUSION_THINGS
};

extern const char *const occlusion_thing_names[OCCLUSION_THINGS];

struct occlusion_case {
    enum occlusion_thing thing;
    double size; // height of the walls, of the bar's middle; radius of the ball; scene units
    double x;    // of the floor's point; of the shaft its radius
};

// The distance of floor and thing from (x, y, 0), or for the shaft from (0, y, 0), exact outside.
double occlusion_distance(const struct occlusion_case *scene, double y);

// The openness of the floor's point, by brute force on n x n points, and in closed form.
double occlusion_brute(const struct occlusion_case *scene, int n);
double occlusion_truth(const struct occlusion_case *scene);

// The same by five taps.
double occlusion_taps(const struct occlusion_case *scene, double reach, double strength);

// ---- The table of errors ----

struct occlusion_error {
    double mean, mean_size, worst; // formula less truth; of its size; the largest size
};

// Over the fields of the experiment 14_map, with a reach of 1.
//   strength  0: nothing hides the sky
struct occlusion_error occlusion_error_of(enum occlusion_thing thing, double strength);

// Over the pixels of chapter 14's picture that see no sky, drawn at 160x90 by
// tests/shaders/openness.frag.
//   formula  as there. It needs the context of gpu.h.
struct occlusion_error occlusion_scene_error(int formula);

// Print the tables that docs/14_occlusion.md quotes. An exit status.
int occlusion_print(void);

#endif
