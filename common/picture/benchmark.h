// benchmark.h - what a shader costs on this machine: compilation, frames, evaluations of the scene.
#ifndef BENCHMARK_H
#define BENCHMARK_H

#include <stdbool.h>
#include <stdio.h>

#include "context/context.h"
#include "picture/renderer.h"

#define BENCHMARK_FRAMES_LIMIT   10000
#define BENCHMARK_FRAMES_DEFAULT 20
#define BENCHMARK_WARM_UP        3 // frames that are drawn and not counted, the first one included

// The clocks of one piece of work, in seconds.
enum benchmark_clock {
    BENCHMARK_CPU,  // of the process, all its threads together: other programs do not count
    BENCHMARK_WALL, // what a person waits
    BENCHMARK_GPU,  // GL_TIME_ELAPSED, on a graphics card; 0 without
    BENCHMARK_CLOCKS
};

struct benchmark_span {
    double seconds[BENCHMARK_CLOCKS];
};

// What marches took against the least that could have shown the same: shaders/cover.glsl. Where a
// coarse pass marches for many rays at once, its evaluations are shared out among all pixels, and
// the least is that of a ray by itself: so the march may come below it.
struct benchmark_cover {
    int rays;                // looked at, of those that march; 0: nothing is known
    double march, bound;     // evaluations, the mean over these rays
    double ratio, ray_ratio; // march / bound, and the smallest of a single ray
};

struct benchmark {
    // Given.
    const char *shader; // its name, for the report
    int frames;
    struct renderer_inputs inputs;
    // Measured.
    char backend[512];                              // as context_describe has it
    bool has_gpu;                                   // the GPU's clock was read
    struct benchmark_span compile, first;           // with the drivers' own caches off
    struct benchmark_span median, minimum, maximum; // of the frames, by clock
    bool has_evaluations;                           // the course's form counts them
    // Evaluations of a pixel: the mean, with those of the coarse pass; what 99 % of the pixels have
    // at most, and all, in their own marches.
    double mean, percentile, most;
    struct benchmark_cover cover; // of the first marches, by the same count
};

// Of numbers in any order: the least, the one in the middle (the mean of two where their count is
// even), the largest.
struct benchmark_spread {
    double minimum, median, maximum;
};

//   values  count >= 1 of them; they are sorted
struct benchmark_spread benchmark_spread_of(double *values, int count);

// renderer_load, timed.
bool benchmark_load(struct benchmark *benchmark, struct renderer *renderer,
                    struct shader_source *source, struct parameters *parameters);

// Draw the first frame, the warm-up, and the frames that count; then count evaluations on the GPU.
//   benchmark  shader, frames (from 1 on) and inputs are set, benchmark_load was called
//   context    the renderer's own
// Returns false, reported.
bool benchmark_run(struct benchmark *benchmark, const struct context *context,
                   struct renderer *renderer);

// Print the numbers: aligned text, or one JSON object with one name a line. Milliseconds; what was
// not measured is "-", null in JSON.
void benchmark_print(const struct benchmark *benchmark, bool json, FILE *file);

#endif
