// coarse.h - the scene of tests/shaders/coarse.frag, on the GPU and in double.
#ifndef TESTS_COARSE_H
#define TESTS_COARSE_H

#include "lib/gpu.h"
#include "lib/mirror.h"

#define COARSE_SHADER "tests/shaders/coarse.frag"

enum { COARSE_BALLS = 4 };

// The numbers of tests/shaders/coarse.frag, as they are given to it.
struct coarse_scene {
    struct d3 ball[COARSE_BALLS], wire[2];
    double radius[COARSE_BALLS], wire_radius;
    double threshold, growth, factor, orthographic, framing, focal_length;
};

// As a float holds it.
static inline double coarse_float(double value)
{
    return (double)(float)value;
}

// Give all of them to the shader, which is loaded.
void coarse_set_scene(const struct coarse_scene *scene);

// ---- In double ----

// How far the scene is from p.
double coarse_distance(const struct coarse_scene *scene, struct d3 p);

// The shader's coarseMargin at t of a ray.
double coarse_margin(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                     double t);

// The ray of a place in the picture, in pixels.
struct mirror_ray coarse_ray(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                             double x, double y);

// What a float's rounding does to a distance at t of a ray: some eight roundings of numbers no
// larger than that.
double coarse_slack(struct mirror_ray ray, double t);

// ---- A picture ----

// The blocks along a side of so many pixels.
int coarse_blocks(int pixels);

// Draw, and read the table of the coarse pass: 4 floats a block, which the caller frees.
float *coarse_table(const struct renderer_inputs *inputs);

// ---- A wire ----

enum {
    COARSE_WIDE = 200,
    COARSE_HIGH = 120
}; // pixels of the picture in which the wire is half a pixel wide

// A wire across the picture of a camera 7 in front of the origin, half a pixel wide where it is,
// between balls: near ones that cones slip by, and one behind, on which it would be lost.
//   growth  of the threshold, in half pixels
//   lean    of the wire: its slope
struct coarse_scene coarse_wire(double growth, double lean);

#endif
