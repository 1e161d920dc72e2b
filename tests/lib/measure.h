// measure.h - the numbers that the pages of docs/ quote: build/tests/measure prints them, and
// tests/shaders/measure.c checks them.
#ifndef TESTS_MEASURE_H
#define TESTS_MEASURE_H

#include "lib/gpu.h"
#include "lib/mirror.h"
#include "lib/shadow.h"

// The largest angle, in degrees, between the true normal of a unit ball with its centre at z = 10
// and the normal from differences of the ball's distance in 32-bit floats; and the values that
// theory expects.
struct normal_error {
    double central, forward;
    double central_truncation, forward_truncation; // the largest truncation errors of the formulas
    double rounding; // an upper bound on the error from rounding z near 10 and the length
};

// The errors of central and forward differences with a step h, over 20,000 points of the ball.
struct normal_error measure_normal(double h);

// The number of moves of a march from height 1 above a plane until its distance is below threshold.
//   angle  the ray's angle below the horizon, degrees, in (0, 90]
// shaders/march.glsl counts one extra step, because its steps are evaluations.
int measure_plane_moves(double angle, double threshold);

// The same count from the formula ceil(ln(threshold) / ln(1 - sin angle)).
int measure_plane_formula(double angle, double threshold);

// The angle, in degrees, below which this many evaluations do not reach the plane.
double measure_plane_limit(int evaluations, double threshold);

// The number of moves of a march past a ball of radius 1 that the ray misses by delta, from 3 units
// before the closest point to 3 units beyond it. With delta 0, the ray is a tangent, and the march
// ends with a hit.
int measure_ball_moves(double delta, double threshold);

// The ratio e_(n+1) / e_n near the hit on a ball of radius 1, where e_n = t* - t_n, and t* is the
// exact hit.
//   cosine  |<N, D>| at the hit, in (0, 1)
double measure_rate(double cosine);

// The largest angle, in degrees, between two normals of a ball: at the point of the ball nearest to
// the end of a march, and at the point where the ray meets the ball. The rays start at a distance
// of 5.
double measure_foot(double radius, double threshold);

// The radius of a ball's outline, in pixels, in a picture of 640x360 drawn by the GPU. The ball has
// radius 1 and is seen from a distance of 5.
double measure_outline(double threshold);

// The radius, in pixels, that geometry predicts for the outline of a ball of radius 1 + threshold
// at the same distance.
double measure_outline_theory(double threshold);

// The share of the lit pixels of the stage in chapter 03 that the GPU wrongly finds in shadow.
//   offset  the parameter shadowOffset, in multiples of the threshold
double measure_acne(double offset);

// The errors of the marches of chapter 13, compared with 1024 rays per pixel, over the pixels of
// the chapter's picture, 160x90, that do not see all of the sun.
//   error  receives the errors of five formulas: hard shadows, the smallest distance / t, pairs of
//          steps, pairs of steps with twice the hardness, and the march that continues inside
//          objects
void measure_shadow_scene(struct shadow_error error[5]);

#endif
