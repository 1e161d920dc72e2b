#include "picture/benchmark.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "json.h"
#include "memory.h"
#include "picture/passes.h"
#include "platform.h"
#include "report.h"

// The GPU's timer.
struct timer {
// Types and lists of parameters cannot have parentheses. NOLINTNEXTLINE(bugprone-macro-parentheses)
#define TIMER_MEMBER(type, name, arguments) type(*name) arguments;
    GL_TIMER_FUNCTIONS(TIMER_MEMBER)
#undef TIMER_MEMBER
    GLuint query;
};

// ---- Clocks ----

static struct benchmark_span now(void)
{
    return (struct benchmark_span){{platform_processor_seconds(), platform_seconds(), 0.0}};
}

static struct benchmark_span since(const struct benchmark_span *begin)
{
    struct benchmark_span span = now();
    for (int i = 0; i < BENCHMARK_CLOCKS; i++)
        span.seconds[i] -= begin->seconds[i];
    return span;
}

// True for a software rasteriser, which has no GPU clock.
static bool is_software(const struct gl *gl)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "swrast", "SWR", "Software"};
    const char *renderer = (const char *)gl->GetString(GL_RENDERER);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (renderer == NULL || strstr(renderer, names[i]) != NULL)
            return true;
    return false;
}

static bool open_timer(struct timer *timer, const struct context *context)
{
    bool has_all = !is_software(&context->gl);
// NOLINTBEGIN(bugprone-macro-parentheses)
#define TIMER_LOAD(type, name, arguments)                                                          \
    timer->name = (type(*) arguments)context->driver->find("gl" #name);                            \
    has_all = has_all && timer->name != NULL;
    GL_TIMER_FUNCTIONS(TIMER_LOAD)
// NOLINTEND(bugprone-macro-parentheses)
#undef TIMER_LOAD
    if (has_all)
        timer->GenQueries(1, &timer->query);
    return has_all;
}

// ---- Frames ----

bool benchmark_load(struct benchmark *benchmark, struct renderer *renderer,
                    struct shader_source *source, struct parameters *parameters)
{
    struct benchmark_span begin = now();
    if (!renderer_load(renderer, source, parameters))
        return false;
    renderer->gl->Finish();
    benchmark->compile = since(&begin);
    return true;
}

// The inputs of a frame. If frames are kept, each one continues the last.
//   more  frames that were drawn before
static struct renderer_inputs inputs_after(const struct benchmark *benchmark,
                                           const struct renderer *renderer, int more)
{
    const struct renderer_inputs *inputs = &benchmark->inputs;
    return passes_keep(renderer) ? passes_inputs(inputs, inputs->frame + more) : *inputs;
}

// Draw and time one frame.
//   timer  NULL if there is no GPU clock
//   more   as for inputs_after
static bool draw_frame(const struct benchmark *benchmark, struct renderer *renderer,
                       const struct timer *timer, struct benchmark_span *span, int more)
{
    struct renderer_inputs inputs = inputs_after(benchmark, renderer, more);
    GLuint64 nanoseconds = 0;
    struct benchmark_span begin = now();
    if (timer != NULL)
        timer->BeginQuery(GL_TIME_ELAPSED, timer->query);
    bool done = renderer_draw(renderer, &inputs, 0, inputs.height);
    if (timer != NULL)
        timer->EndQuery(GL_TIME_ELAPSED);
    renderer->gl->Finish();
    *span = since(&begin);
    if (timer != NULL)
        timer->GetQueryObjectui64v(timer->query, GL_QUERY_RESULT, &nanoseconds);
    span->seconds[BENCHMARK_GPU] = 1e-9 * (double)nanoseconds;
    return done;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

struct benchmark_spread benchmark_spread_of(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, compare_doubles);
    return (struct benchmark_spread){values[0], 0.5 * (values[(count - 1) / 2] + values[count / 2]),
                                     values[count - 1]};
}

static bool draw_frames(struct benchmark *benchmark, struct renderer *renderer,
                        const struct timer *timer)
{
    int count = benchmark->frames, all = BENCHMARK_WARM_UP + count;
    struct benchmark_span *span = memory_zeros((size_t)all, sizeof *span);
    double *seconds = memory_zeros((size_t)count, sizeof *seconds);
    bool done = true;
    for (int i = 0; i < all && done; i++)
        done = draw_frame(benchmark, renderer, timer, &span[i], i);
    benchmark->first = span[0];
    for (int clock = 0; clock < BENCHMARK_CLOCKS && done; clock++) {
        for (int i = 0; i < count; i++)
            seconds[i] = span[BENCHMARK_WARM_UP + i].seconds[clock];
        struct benchmark_spread spread = benchmark_spread_of(seconds, count);
        benchmark->minimum.seconds[clock] = spread.minimum;
        benchmark->median.seconds[clock] = spread.median;
        benchmark->maximum.seconds[clock] = spread.maximum;
    }
    free(seconds);
    free(span);
    return done;
}

// ---- Evaluations ----

// Draw the counts of all pixels as shaders/main.glsl writes them, 4 numbers per pixel: evaluations,
// steps of the first march, the lower bound, and 1 if the pixel is on the grid of
// shaders/cover.glsl. Outside this grid, the steps and the bound are 0.
static bool draw_counts(struct renderer *renderer, const struct renderer_inputs *inputs,
                        float *values)
{
    bool done = renderer_set_view(renderer, VIEW_COVER) &&
                renderer_draw(renderer, inputs, 0, inputs->height);
    if (done)
        target_read(&renderer->picture, renderer->gl, values);
    return done;
}

// Compare the marches with the bounds.
//   counts  the counts with the coarse pass, if there is one
//   alone   the counts without the coarse pass, from which the bounds are taken
//   shared  evaluations of the coarse pass per pixel
static struct benchmark_cover cover_of(const float *counts, const float *alone, double shared,
                                       size_t pixels)
{
    struct benchmark_cover cover = {0};
    double march = 0.0, bound = 0.0;
    for (size_t i = 0; i < pixels; i++) {
        double steps = (double)counts[4 * i + 1], least = (double)alone[4 * i + 2];
        march += (double)counts[4 * i + 3] * shared;
        if (least == 0.0)
            continue;
        march += steps;
        bound += least;
        if (cover.rays == 0 || (steps + shared) / least < cover.ray_ratio)
            cover.ray_ratio = (steps + shared) / least;
        cover.rays++;
    }
    if (cover.rays > 0) {
        cover.march = march / cover.rays;
        cover.bound = bound / cover.rays;
        cover.ratio = march / bound;
    }
    return cover;
}

// Count the evaluations of the coarse pass per pixel, and draw the counts again without the pass.
static bool count_coarse(struct renderer *renderer, const struct renderer_inputs *inputs,
                         float *values, double *shared)
{
    struct parameter *pass = parameters_find(&renderer->parameters, "coarsePass");
    size_t pixels = (size_t)inputs->width * (size_t)inputs->height;
    size_t blocks = (size_t)renderer->coarse.width * (size_t)renderer->coarse.height;
    double sum = 0.0;
    target_read(&renderer->coarse, renderer->gl, values); // fewer texels than the picture
    for (size_t i = 0; i < blocks; i++)
        sum += (double)values[4 * i + 1];
    *shared = sum / (double)pixels;
    double on = pass->value[0];
    pass->value[0] = 0.0;
    bool done = draw_counts(renderer, inputs, values);
    pass->value[0] = on;
    return done;
}

// Sum up the evaluations of all pixels.
//   each  room for one number per pixel
static void sum_up(struct benchmark *benchmark, const float *counts, double shared, size_t pixels,
                   double *each)
{
    double sum = 0.0;
    for (size_t i = 0; i < pixels; i++)
        sum += each[i] = (double)counts[4 * i];
    benchmark->most = benchmark_spread_of(each, (int)pixels).maximum;
    benchmark->mean = sum / (double)pixels + shared;
    benchmark->percentile = each[(size_t)ceil(0.99 * (double)pixels) - 1];
    benchmark->has_evaluations = true;
}

static bool count_evaluations(struct benchmark *benchmark, struct renderer *renderer)
{
    enum shader_view view = renderer->view;
    struct renderer_inputs inputs =
        inputs_after(benchmark, renderer, BENCHMARK_WARM_UP + benchmark->frames - 1);
    size_t pixels = (size_t)inputs.width * (size_t)inputs.height;
    float *counts = malloc(4 * sizeof *counts * pixels);
    float *alone = malloc(4 * sizeof *alone * pixels);
    double *each = malloc(sizeof *each * pixels), shared = 0.0;
    inputs.samples = 1;
    bool done = counts != NULL && alone != NULL && each != NULL;
    if (!done)
        report("--benchmark: not enough memory: try a smaller --size%s", memory_limit());
    done = done && draw_counts(renderer, &inputs, counts);
    if (done)
        memcpy(alone, counts, 4 * sizeof *alone * pixels);
    if (done && renderer_wants_coarse(renderer, VIEW_COVER))
        done = count_coarse(renderer, &inputs, alone, &shared);
    if (done) {
        sum_up(benchmark, counts, shared, pixels, each);
        benchmark->cover = cover_of(counts, alone, shared, pixels);
    }
    free(counts);
    free(alone);
    free(each);
    return renderer_set_view(renderer, view) && done;
}

bool benchmark_run(struct benchmark *benchmark, const struct context *context,
                   struct renderer *renderer)
{
    struct timer timer = {0};
    bool timed = benchmark->has_gpu = open_timer(&timer, context);
    context_describe(context, benchmark->backend, sizeof benchmark->backend);
    bool done = draw_frames(benchmark, renderer, timed ? &timer : NULL);
    if (timed)
        timer.DeleteQueries(1, &timer.query);
    if (done && renderer->fragment.dialect == DIALECT_COURSE)
        done = count_evaluations(benchmark, renderer);
    GLenum error = renderer->gl->GetError();
    if (done && error != GL_NO_ERROR)
        report("--benchmark: OpenGL error 0x%04x: try a smaller --size", error);
    return done && error == GL_NO_ERROR;
}

// ---- Report ----

static void print_row(FILE *file, const char *name, const struct benchmark_span *span, int clocks)
{
    fprintf(file, "%-14s", name);
    for (int i = 0; i < clocks; i++)
        fprintf(file, " %10.3f", 1000.0 * span->seconds[i]);
    fprintf(file, "\n");
}

static void print_text(const struct benchmark *b, FILE *file)
{
    int clocks = b->has_gpu ? BENCHMARK_CLOCKS : BENCHMARK_GPU;
    fprintf(file, "%-14s %s\n%-14s %s\n", "shader", b->shader, "backend", b->backend);
    fprintf(file, "%-14s %dx%d, time %g s, samples per pixel: %d, frames: %d\n\n", "picture",
            b->inputs.width, b->inputs.height, b->inputs.time,
            b->inputs.samples * b->inputs.samples, b->frames);
    fprintf(file, "%-14s %10s %10s%s\n", "milliseconds", "cpu", "wall",
            b->has_gpu ? "        gpu" : "");
    print_row(file, "cold compile", &b->compile, BENCHMARK_GPU);
    print_row(file, "first frame", &b->first, clocks);
    print_row(file, "frame, median", &b->median, clocks);
    print_row(file, "minimum", &b->minimum, clocks);
    print_row(file, "maximum", &b->maximum, clocks);
    fprintf(file, "\n%-14s ", "evaluations");
    if (b->has_evaluations)
        fprintf(file, "mean %.2f, 99 %% of the pixels at most %.0f, maximum %.0f\n", b->mean,
                b->percentile, b->most);
    else
        fprintf(file, "- (counted only in the course's dialect)\n");
    if (b->cover.rays > 0)
        fprintf(file,
                "%-14s %.2f evaluations per ray, lower bound %.2f: march / bound %.2f, for one "
                "ray at least %.2f; rays: %d\n",
                "march", b->cover.march, b->cover.bound, b->cover.ratio, b->cover.ray_ratio,
                b->cover.rays);
}

static void json_span(struct json *json, const char *name, const struct benchmark_span *span,
                      bool has_gpu)
{
    static const char *const clocks[BENCHMARK_CLOCKS] = {"cpu", "wall", "gpu"};
    for (int i = 0; i < BENCHMARK_CLOCKS; i++) {
        char key[40];
        snprintf(key, sizeof key, "%s_%s_ms", name, clocks[i]);
        json_number(json, key, i != BENCHMARK_GPU || has_gpu ? 1000.0 * span->seconds[i] : NAN, 4);
    }
}

static void print_json(const struct benchmark *b, FILE *file)
{
    struct json json = {.stream = file, .lines = true};
    bool counted = b->has_evaluations, covered = b->cover.rays > 0;
    json_begin(&json, NULL, '{');
    json_text(&json, "shader", b->shader);
    json_text(&json, "backend", b->backend);
    json_number(&json, "width", b->inputs.width, 0);
    json_number(&json, "height", b->inputs.height, 0);
    json_number(&json, "time", b->inputs.time, -1);
    json_number(&json, "samples", b->inputs.samples * b->inputs.samples, 0);
    json_number(&json, "frames", b->frames, 0);
    json_span(&json, "compile", &b->compile, false);
    json_span(&json, "first_frame", &b->first, b->has_gpu);
    json_span(&json, "frame_median", &b->median, b->has_gpu);
    json_span(&json, "frame_minimum", &b->minimum, b->has_gpu);
    json_span(&json, "frame_maximum", &b->maximum, b->has_gpu);
    json_number(&json, "evaluations_mean", counted ? b->mean : NAN, 4);
    json_number(&json, "evaluations_p99", counted ? b->percentile : NAN, 0);
    json_number(&json, "evaluations_maximum", counted ? b->most : NAN, 0);
    json_number(&json, "march_rays", b->cover.rays, 0);
    json_number(&json, "march_evaluations", covered ? b->cover.march : NAN, 4);
    json_number(&json, "march_bound", covered ? b->cover.bound : NAN, 4);
    json_number(&json, "march_over_bound", covered ? b->cover.ratio : NAN, 4);
    json_number(&json, "march_over_bound_minimum", covered ? b->cover.ray_ratio : NAN, 4);
    json_end(&json, '}');
}

void benchmark_print(const struct benchmark *benchmark, bool json, FILE *file)
{
    if (json)
        print_json(benchmark, file);
    else
        print_text(benchmark, file);
}
