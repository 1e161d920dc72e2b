// coarse.h - the scene of tests/shaders/coarse.frag, on the GPU and in double precision.
#ifndef TESTS_COARSE_H
#define TESTS_COARSE_H

#include "lib/gpu.h"
#include "lib/mirror.h"

#define COARSE_SHADER "tests/shaders/coarse.frag"

enum { COARSE_BALLS = 4 };

// The inputs of tests/shaders/coarse.frag, except `moved`.
struct coarse_scene {
    struct d3 ball[COARSE_BALLS], wire[2];
    double radius[COARSE_BALLS], wire_radius;
    double threshold, growth, factor, orthographic, framing, focal_length;
};

// The value, rounded to a float.
static inline double coarse_float(double value)
{
    return (double)(float)value;
}

// Pass all inputs of a scene to the shader, which must be loaded.
void coarse_set_scene(const struct coarse_scene *scene);

// ---- In double ----

// The distance from p to the scene, multiplied by the scene's factor.
double coarse_distance(const struct coarse_scene *scene, struct d3 p);

// The shader's coarseMargin at the distance t along a ray.
double coarse_margin(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                     double t);

// The ray through a position in the picture, in pixels.
struct mirror_ray coarse_ray(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                             double x, double y);

// An upper bound on the rounding error of a distance at t along a ray: sixteen roundings of a
// number as large as |origin| + t + 1.
double coarse_slack(struct mirror_ray ray, double t);

// ---- A picture ----

// The number of blocks along a side of this many pixels.
int coarse_blocks(int pixels);

// Draw a picture, and read the table of its coarse pass: 4 floats per block, which the caller
// frees. Fails the test if that is impossible.
float *coarse_table(const struct renderer_inputs *inputs);

// ---- A wire ----

enum { COARSE_WIDE = 200, COARSE_HIGH = 120 }; // the size of the picture for coarse_wire, in pixels

// A wire across the picture of a camera that is 7 units in front of the origin. The wire is half a
// pixel wide. Some balls are so close to the wire that cones only just pass them. One ball is
// behind the middle of the wire, and is seen there if the wire is missed.
//   growth  growth of the threshold along the ray, in half pixels
//   lean    slope of the wire
struct coarse_scene coarse_wire(double growth, double lean);

#endif
