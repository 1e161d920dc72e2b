// measure.h - the numbers that the pages quote: build/tests/measure prints them, and test_measure
// checks them.
#ifndef TESTS_MEASURE_H
#define TESTS_MEASURE_H

#include "lib/gpu.h"
#include "lib/mirror.h"
#include "lib/shadow.h"

// The largest angle, in degrees, between the normal of the unit ball with its centre at z = 10 and
// the normal from differences of its distance, all in 32-bit floats; and the values that theory
// expects.
struct normal_error {
    double central, forward;
    double central_truncation, forward_truncation; // largest, from the formula's own error
    double rounding;                               // bound, from rounding z near 10 and the length
};

// The error of both differences at a step h, over some thousand points of the ball.
struct normal_error measure_normal(double h);

// The number of moves of a march from height 1 over a plane until it is nearer than threshold.
//   angle  of the ray below the horizon, degrees, in (0, 90]
// The steps of shaders/march.glsl are one more, because they count evaluations.
int measure_plane_moves(double angle, double threshold);

// The same from ceil(ln(threshold) / ln(1 - sin angle)).
int measure_plane_formula(double angle, double threshold);

// The angle, in degrees, at which this many evaluations do not reach the plane.
double measure_plane_limit(int evaluations, double threshold);

// The number of moves of a march past a ball of radius 1 that its ray misses by delta, from 3
// before the closest point to 3 behind it; with delta 0 the ray is a tangent, which ends as a hit.
int measure_ball_moves(double delta, double threshold);

// e_(n+1) / e_n near the hit, e_n = t* - t_n, on a ball of radius 1.
//   cosine  |<N, D>| at the hit, in (0, 1)
double measure_rate(double cosine);

// The largest angle, in degrees, between the normal of a ball below the end of a march and its
// normal where the ray meets it, over rays that meet it from a distance of 5.
double measure_foot(double radius, double threshold);

// The radius of a ball's outline, in pixels, as the GPU draws it: 640x360, radius 1 seen from a
// distance of 5.
double measure_outline(double threshold);

// The same for a ball of radius 1 + threshold, from geometry.
double measure_outline_theory(double threshold);

// The share of the lit pixels of the stage in chapter 03 that the GPU finds in their own shadow.
//   offset  the parameter shadowOffset, times the threshold
double measure_acne(double offset);

// How far each march of chapter 13 is from 1024 rays per pixel, over the pixels of its picture,
// 160x90, that do not see all of the sun.
//   error  takes five: hard, the smallest distance / t, pairs of steps, the same twice as hard, on
//          inside
void measure_shadow_scene(struct shadow_error error[5]);

#endif
