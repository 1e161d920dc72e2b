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
#define BENCHMARK_WARM_UP        3 // frames that are drawn before those that count

// The clocks of one piece of work, in seconds.
enum benchmark_clock {
    BENCHMARK_CPU,  // of this process, in all its threads
    BENCHMARK_WALL, // the time that a person waits
    BENCHMARK_GPU,  // GL_TIME_ELAPSED; 0 without a graphics card
    BENCHMARK_CLOCKS
};

struct benchmark_span {
    double seconds[BENCHMARK_CLOCKS];
};

// The evaluations of marches, and a lower bound for any march with the same result:
// shaders/cover.glsl. The evaluations of a coarse pass, which marches for many rays at once, are
// divided among all pixels. The bound is that of a single ray, so a march with a coarse pass may be
// below it.
struct benchmark_cover {
    int rays;                // that were compared; 0: unknown
    double march, bound;     // evaluations, the mean of these rays
    double ratio, ray_ratio; // march / bound, and the smallest of a single ray
};

struct benchmark {
    // Given.
    const char *shader; // its name, for the report
    int frames;
    struct renderer_inputs inputs;
    // Measured.
    char backend[512];                              // from context_describe
    bool has_gpu;                                   // the GPU's clock was read
    struct benchmark_span compile, first;           // without the drivers' caches
    struct benchmark_span median, minimum, maximum; // of the frames, by clock
    bool has_evaluations;                           // only the course's dialect counts them
    // Evaluations per pixel: the mean, including the coarse pass; the 99th percentile and the
    // maximum, without it.
    double mean, percentile, most;
    struct benchmark_cover cover; // of the first marches, by the same count
};

struct benchmark_spread {
    double minimum, median, maximum;
};

// The spread of numbers; the median of an even count is the mean of the two in the middle.
//   values  count >= 1 of them; they are sorted
struct benchmark_spread benchmark_spread_of(double *values, int count);

// renderer_load, timed.
bool benchmark_load(struct benchmark *benchmark, struct renderer *renderer,
                    struct shader_source *source, struct parameters *parameters);

// Draw the warm-up and the frames that count; then count evaluations on the GPU.
//   benchmark  shader, frames (at least 1) and inputs are set, benchmark_load was called
//   context    of the renderer
// Returns false, reported.
bool benchmark_run(struct benchmark *benchmark, const struct context *context,
                   struct renderer *renderer);

// Print the numbers: aligned text, or one JSON object with one name per line. Times are
// milliseconds; a number that was not measured is "-", or null in JSON.
void benchmark_print(const struct benchmark *benchmark, bool json, FILE *file);

#endif
