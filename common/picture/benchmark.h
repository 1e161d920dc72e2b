// benchmark.h - the cost of a shader on this machine: compilation, frames, evaluations of the
// scene.
#ifndef BENCHMARK_H
#define BENCHMARK_H

#include <stdbool.h>
#include <stdio.h>

#include "context/context.h"
#include "picture/renderer.h"

#define BENCHMARK_FRAMES_LIMIT   10000
#define BENCHMARK_FRAMES_DEFAULT 20
#define BENCHMARK_WARM_UP        3 // frames drawn before the timed ones

// The clocks that time a piece of work, in seconds.
enum benchmark_clock {
    BENCHMARK_CPU,  // processor time of this process, in all its threads
    BENCHMARK_WALL, // elapsed time, as a user experiences it
    BENCHMARK_GPU,  // GL_TIME_ELAPSED; 0 without a graphics card
    BENCHMARK_CLOCKS
};

struct benchmark_span {
    double seconds[BENCHMARK_CLOCKS];
};

// The evaluations of marches, and a lower bound for any march with the same result, as
// shaders/cover.glsl defines it. The evaluations of a coarse pass, which marches for many rays at
// once, are divided among all pixels. The bound is for a single ray, so a march with a coarse pass
// may take fewer evaluations.
struct benchmark_cover {
    int rays;                // number of rays that were compared; 0 if unknown
    double march, bound;     // evaluations per ray, averaged over these rays
    double ratio, ray_ratio; // march / bound, and its smallest value for a single ray
};

struct benchmark {
    // Set by the caller.
    const char *shader; // the shader's name, for the report
    int frames;
    struct renderer_inputs inputs;
    // Set by benchmark_load and benchmark_run.
    char backend[512];                              // from context_describe
    bool has_gpu;                                   // the GPU's clock could be read
    struct benchmark_span compile, first;           // with the driver's caches switched off
    struct benchmark_span median, minimum, maximum; // over the timed frames, for each clock
    bool has_evaluations;                           // counted only in the course's dialect
    // Evaluations per pixel: the mean, which includes the coarse pass, and the 99th percentile and
    // the maximum, which do not.
    double mean, percentile, most;
    struct benchmark_cover cover; // for the first marches of a grid of pixels, from the same counts
};

struct benchmark_spread {
    double minimum, median, maximum;
};

// Return the minimum, median and maximum of some values. The median of an even number of values is
// the mean of the middle two.
//   values  an array of count values, at least 1, which the function sorts
struct benchmark_spread benchmark_spread_of(double *values, int count);

// Call renderer_load, time the call, and return its result.
bool benchmark_load(struct benchmark *benchmark, struct renderer *renderer,
                    struct shader_source *source, struct parameters *parameters);

// Draw the warm-up frames and the timed frames, and then a picture that counts evaluations.
//   benchmark  its shader, frames (at least 1) and inputs are set, and benchmark_load has run
//   context    the renderer's context
// Returns false after reporting the error.
bool benchmark_run(struct benchmark *benchmark, const struct context *context,
                   struct renderer *renderer);

// Print the results, as aligned text or as one JSON object with one member per line. Times are in
// milliseconds. A number that was not measured is null in JSON; the text omits it, or shows "-"
// instead of the evaluations.
void benchmark_print(const struct benchmark *benchmark, bool json, FILE *file);

#endif
