// cover.h - the fewest evaluations of a distance along a ray that show an interval to be empty, as
// in docs/benchmark.md, in double precision.
#ifndef TESTS_COVER_H
#define TESTS_COVER_H

#include <limits.h>
#include <stdbool.h>

#define COVER_NEVER INT_MAX

// One evaluation: a distance d at t shows that there is nothing between t - d and t + d.
struct cover_sample {
    double t, d;
};

// The smallest number of evaluations, between two bounds.
struct cover_count {
    int least; // no choice of points on the ray needs fewer, if the distance is 1-Lipschitz
    int most;  // the smallest number of the given samples that is enough
};

// Find how many evaluations cover a ray from its first sample to its last.
//   sample  t ascending, count >= 1; a negative d counts as 0
//   hit     true if the last sample is a hit; one evaluation is then made there
// A bound is COVER_NEVER if the samples are not enough for it.
//
// For a 1-Lipschitz distance, t - d and t + d never decrease along the ray. Between two samples,
// t - d is therefore at least its value at the first sample, and t + d at most its value at the
// second. The intervals of all points between the samples lie in the wide interval from the one
// value to the other. `least` is the smallest number of such wide intervals that cover the ray.
struct cover_count cover_of(const struct cover_sample *sample, int count, bool hit);

// The next three functions are for a distance that changes at a constant rate along the ray,
// d = height - slope t with -1 < slope < 1: a plane that the ray approaches (slope > 0) or leaves.

// The number of evaluations of a march from t = 0 until d is below threshold, or t is at least far.
int cover_plane_march(double height, double slope, double far, double threshold, bool *hit);

// The smallest number of evaluations that give the same answer as the march of cover_plane_march.
int cover_plane_least(double height, double slope, double far, double threshold);

// The limit of cover_plane_march / cover_plane_least as both counts grow:
// ln((1 - slope) / (1 + slope)) / ln(1 - slope), or 2 for slope 0.
double cover_plane_ratio(double slope);

// The same two counts for a ray that passes a ball of radius 1 at a distance of 1 + gap from its
// centre, from -reach to reach around the closest point, with threshold 0.
int cover_ball_march(double gap, double reach);
int cover_ball_least(double gap, double reach);

#endif
