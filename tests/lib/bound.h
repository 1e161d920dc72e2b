// bound.h - compares the marches of a chapter with the fewest evaluations that would be enough. The
// marches come from probes on the GPU; bounds on the fewest evaluations are computed from the scene
// in double precision.
#ifndef TESTS_BOUND_H
#define TESTS_BOUND_H

#include "lib/cover.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

struct bound_case {
    const char *stem;
    const struct mirror_scene *scene; // the chapter's scene, in double precision
    double threshold, spread;         // a distance at t below threshold + spread t is a hit
};

extern const struct bound_case bound_cases[];
extern const int bound_case_count;

// Sums and extremes over rays.
struct bound_sums {
    int rays, march;  // the number of rays, and the evaluations of their marches
    int least, most;  // bounds on the fewest evaluations that would be enough
    int shader;       // the fewest evaluations, as computed by shaders/cover.glsl
    int astray;       // rays for which the shader's count is outside the bounds
    int below;        // rays whose march takes fewer evaluations than the lower bound
    double smallest;  // the smallest ratio of a march's evaluations to the lower bound
    double lipschitz; // the largest change of the scene's distance from one sample of a ray to the
                      // next, per scene unit
    int given_up, differ; // rays that ran out of steps; rays whose step count in the picture
                          // differs from the probe's
};

// Follow the rays of the chapter's first picture, 640x360, that shaders/cover.glsl selects.
//   every  1 for all of these rays, n for every nth
//   sums   receives the sums over the misses, then those over the hits
// Fails the test, or ends the program, if the picture cannot be drawn.
void bound_measure(const struct bound_case *of, int every, struct bound_sums sums[2]);

// March one ray on the GPU, in tests/shaders/cover.frag. The parameters are those of that shader.
//   answer  receives the steps of the march, and the fewest possible steps as computed by
//           shaders/cover.glsl
// Fails the test if the ray cannot be drawn.
void bound_ask(double slope, double gap, double far, double threshold, int answer[2]);

#endif
