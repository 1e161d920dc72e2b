// bound.h - compares the marches of a chapter with the fewest evaluations that would be enough. The
// marches come from probes on the GPU, the bound from the scene in double precision.
#ifndef TESTS_BOUND_H
#define TESTS_BOUND_H

#include "lib/cover.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

struct bound_case {
    const char *stem;
    const struct mirror_scene *scene; // its distance in double
    double threshold, spread;         // a hit at t is nearer than threshold + spread t
};

extern const struct bound_case bound_cases[];
extern const int bound_case_count;

// Sums over rays.
struct bound_sums {
    int rays, march;      // evaluations of the march
    int least, most;      // the fewest that would be enough, between these
    int shader;           // the same, computed by shaders/cover.glsl
    int astray;           // rays for which that is not between them
    int below;            // rays whose march takes fewer than the lower bound
    double smallest;      // march / lower bound of one ray
    double lipschitz;     // the largest change of the distance between samples, per scene unit
    int given_up, differ; // rays that ran out of steps; rays whose steps differ from the probe's
};

// Follow rays of the chapter's first picture, 640x360: those that shaders/cover.glsl chooses.
//   every  1 for all of them, n for each nth
//   sums   takes misses, then hits
// Fails the test, or ends the program, if it cannot be drawn.
void bound_measure(const struct bound_case *of, int every, struct bound_sums sums[2]);

// March one ray on the GPU, in tests/shaders/cover.frag, with the parameters that this file
// declares.
//   answer  receives the steps of the march, and the fewest possible steps, by shaders/cover.glsl
// Fails the test if the ray cannot be drawn.
void bound_ask(double slope, double gap, double far, double threshold, int answer[2]);

#endif
