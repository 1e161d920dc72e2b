#include "picture/benchmark.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "platform.h"
#include "report.h"
#include "picture/coarse.h"

// OpenGL ES 3.0 has no timer: these are asked for where they are used, not in the table of gl.h.
struct timer {
    PFNGLGENQUERIESPROC gen;
    PFNGLDELETEQUERIESPROC drop;
    PFNGLBEGINQUERYPROC begin;
    PFNGLENDQUERYPROC end;
    PFNGLGETQUERYOBJECTUI64VPROC get;
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

// A processor that plays the graphics card has no clock of its own.
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
    gl_function (*find)(const char *) = context->driver->find;
    if (is_software(&context->gl))
        return false;
    *timer = (struct timer){.gen = (PFNGLGENQUERIESPROC)find("glGenQueries"),
                            .drop = (PFNGLDELETEQUERIESPROC)find("glDeleteQueries"),
                            .begin = (PFNGLBEGINQUERYPROC)find("glBeginQuery"),
                            .end = (PFNGLENDQUERYPROC)find("glEndQuery"),
                            .get = (PFNGLGETQUERYOBJECTUI64VPROC)find("glGetQueryObjectui64v")};
    if (timer->gen == NULL || timer->drop == NULL || timer->begin == NULL || timer->end == NULL ||
        timer->get == NULL)
        return false;
    timer->gen(1, &timer->query);
    return true;
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

//   timer  NULL where there is no GPU's clock
static bool draw_frame(const struct benchmark *benchmark, struct renderer *renderer,
                       const struct timer *timer, struct benchmark_span *span)
{
    GLuint64 nanoseconds = 0;
    struct benchmark_span begin = now();
    if (timer != NULL)
        timer->begin(GL_TIME_ELAPSED, timer->query);
    bool done = renderer_draw(renderer, &benchmark->inputs, 0, benchmark->inputs.height);
    if (timer != NULL)
        timer->end(GL_TIME_ELAPSED);
    renderer->gl->Finish();
    *span = since(&begin);
    if (timer != NULL)
        timer->get(timer->query, GL_QUERY_RESULT, &nanoseconds);
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
    int count = benchmark->frames;
    double *seconds[BENCHMARK_CLOCKS];
    bool done = true;
    for (int clock = 0; clock < BENCHMARK_CLOCKS; clock++)
        seconds[clock] = memory_zeros((size_t)count, sizeof *seconds[clock]);
    for (int i = -BENCHMARK_WARM_UP; i < count && done; i++) {
        struct benchmark_span span;
        done = draw_frame(benchmark, renderer, timer, &span);
        if (i == -BENCHMARK_WARM_UP)
            benchmark->first = span;
        for (int clock = 0; clock < BENCHMARK_CLOCKS && i >= 0; clock++)
            seconds[clock][i] = span.seconds[clock];
    }
    for (int clock = 0; clock < BENCHMARK_CLOCKS && done; clock++) {
        struct benchmark_spread spread = benchmark_spread_of(seconds[clock], count);
        benchmark->minimum.seconds[clock] = spread.minimum;
        benchmark->median.seconds[clock] = spread.median;
        benchmark->maximum.seconds[clock] = spread.maximum;
    }
    for (int clock = 0; clock < BENCHMARK_CLOCKS; clock++)
        free(seconds[clock]);
    return done;
}

// ---- Evaluations ----

// Draw the counts of all pixels: 4 numbers each, as shaders/main.glsl writes them: evaluations,
// steps, the least, whether the pixel's march is looked at.
static bool draw_counts(struct renderer *renderer, const struct renderer_inputs *inputs,
                        float *values)
{
    bool done = renderer_set_view(renderer, SHADER_COUNT) &&
                renderer_draw(renderer, inputs, 0, inputs->height);
    if (done)
        renderer_read(renderer, &renderer->picture, values);
    return done;
}

// Compare the marches of the grid's rays with the least that could have done.
//   counts  as they are drawn
//   alone   of each ray by itself, without the coarse pass: whose march has to be shown, and the
//           least that does it
//   shared  evaluations of the coarse pass for each pixel
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

// The evaluations of the coarse pass, the mean for each pixel; and, in place of the counts that are
// drawn, those without it.
static bool count_coarse(struct renderer *renderer, const struct renderer_inputs *inputs,
                         float *values, double *shared)
{
    struct parameter *pass = parameters_find(&renderer->parameters, "coarsePass");
    size_t pixels = (size_t)inputs->width * (size_t)inputs->height;
    size_t blocks = (size_t)renderer->coarse.width * (size_t)renderer->coarse.height;
    double sum = 0.0;
    renderer_read(renderer, &renderer->coarse, values); // has fewer texels than the picture
    for (size_t i = 0; i < blocks; i++)
        sum += (double)values[4 * i + 1];
    *shared = sum / (double)pixels;
    if (pass == NULL)
        return report("--benchmark: a coarse pass without its parameter coarsePass");
    double on = pass->value[0];
    pass->value[0] = 0.0;
    bool done = draw_counts(renderer, inputs, values);
    pass->value[0] = on;
    return done;
}

//   each  room for as many numbers
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
    struct renderer_inputs inputs = benchmark->inputs;
    size_t pixels = (size_t)inputs.width * (size_t)inputs.height;
    float *counts = malloc(4 * sizeof *counts * pixels);
    float *alone = malloc(4 * sizeof *alone * pixels);
    double *each = malloc(sizeof *each * pixels), shared = 0.0;
    inputs.samples = 1;
    bool done = counts != NULL && alone != NULL && each != NULL;
    if (!done)
        report("--benchmark: not enough memory: try a smaller --size");
    done = done && draw_counts(renderer, &inputs, counts);
    if (done)
        memcpy(alone, counts, 4 * sizeof *alone * pixels);
    if (done && coarse_wanted(renderer, SHADER_COUNT))
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
        timer.drop(1, &timer.query);
    if (done && renderer->fragment.form == SHADER_COURSE)
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
    fprintf(file, "%-14s %dx%d, time %g s, samples a pixel: %d, frames: %d\n\n", "picture",
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
        fprintf(file, "-, a file with a main of its own does not count them\n");
    if (b->cover.rays > 0)
        fprintf(file,
                "%-14s %.2f evaluations a ray, the least %.2f: march / bound %.2f, of one ray at "
                "least %.2f; rays: %d\n",
                "march", b->cover.march, b->cover.bound, b->cover.ratio, b->cover.ray_ratio,
                b->cover.rays);
}

// The lines of a JSON object, each but the first behind a comma.
static void print_string(FILE *file, const char *before, const char *name, const char *text)
{
    fprintf(file, "%s\n  \"%s\": \"", before, name);
    for (const char *c = text; *c != '\0'; c++)
        if (*c == '"' || *c == '\\')
            fprintf(file, "\\%c", *c);
        else
            fputc((unsigned char)*c < ' ' ? '?' : *c, file);
    fprintf(file, "\"");
}

static void print_number(FILE *file, const char *name, double value, int decimals, bool known)
{
    if (known)
        fprintf(file, ",\n  \"%s\": %.*f", name, decimals, value);
    else
        fprintf(file, ",\n  \"%s\": null", name);
}

static void print_span(FILE *file, const char *name, const struct benchmark_span *span,
                       bool has_gpu)
{
    static const char *const clocks[BENCHMARK_CLOCKS] = {"cpu", "wall", "gpu"};
    for (int i = 0; i < BENCHMARK_CLOCKS; i++) {
        char key[40];
        snprintf(key, sizeof key, "%s_%s_ms", name, clocks[i]);
        print_number(file, key, 1000.0 * span->seconds[i], 4, i != BENCHMARK_GPU || has_gpu);
    }
}

static void print_json(const struct benchmark *b, FILE *file)
{
    bool counted = b->has_evaluations, covered = b->cover.rays > 0;
    print_string(file, "{", "shader", b->shader);
    print_string(file, ",", "backend", b->backend);
    print_number(file, "width", b->inputs.width, 0, true);
    print_number(file, "height", b->inputs.height, 0, true);
    fprintf(file, ",\n  \"time\": %.9g", b->inputs.time);
    print_number(file, "samples", b->inputs.samples * b->inputs.samples, 0, true);
    print_number(file, "frames", b->frames, 0, true);
    print_span(file, "compile", &b->compile, false);
    print_span(file, "first_frame", &b->first, b->has_gpu);
    print_span(file, "frame_median", &b->median, b->has_gpu);
    print_span(file, "frame_minimum", &b->minimum, b->has_gpu);
    print_span(file, "frame_maximum", &b->maximum, b->has_gpu);
    print_number(file, "evaluations_mean", b->mean, 4, counted);
    print_number(file, "evaluations_p99", b->percentile, 0, counted);
    print_number(file, "evaluations_maximum", b->most, 0, counted);
    print_number(file, "march_rays", b->cover.rays, 0, true);
    print_number(file, "march_evaluations", b->cover.march, 4, covered);
    print_number(file, "march_bound", b->cover.bound, 4, covered);
    print_number(file, "march_over_bound", b->cover.ratio, 4, covered);
    print_number(file, "march_over_bound_minimum", b->cover.ray_ratio, 4, covered);
    fprintf(file, "\n}\n");
}

void benchmark_print(const struct benchmark *benchmark, bool json, FILE *file)
{
    if (json)
        print_json(benchmark, file);
    else
        print_text(benchmark, file);
}
