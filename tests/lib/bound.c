#include "lib/bound.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "lib/city.h"
#include "lib/pyramid.h"

enum {
    WIDTH = 640,
    HEIGHT = 360,
    PARTS = 64 // samples per step of a march
};

#define HALF_PIXEL (1.0 / (HEIGHT * MIRROR_FOCAL_LENGTH))

const struct bound_case bound_cases[] = {
    {"03_shadows", &mirror_scene_02, 0.0005, 0.0},
    {"06_sierpinski_symmetry", &pyramid_scene, 0.0002, 1.5 * HALF_PIXEL},
    {"09_sky_and_sunset", &city_scene, 0.002, HALF_PIXEL},
};
const int bound_case_count = sizeof bound_cases / sizeof bound_cases[0];

// ---- The samples of one ray ----

struct samples {
    struct cover_sample *item;
    int count;
    bool hit, given_up;
};

static void add(struct samples *samples, const struct bound_case *of, struct mirror_ray ray,
                double t)
{
    double d = mirror_distance(of->scene, mirror_at(ray, t), NULL);
    samples->item[samples->count++] = (struct cover_sample){t, d};
}

// Take samples between the steps of the march that the probe reports, from the start of its
// interval to the hit or to the end of the interval.
static void sample_ray(struct samples *samples, const struct bound_case *of, struct mirror_ray ray,
                       const struct probe *probe)
{
    const struct probe_step *last = &probe->step[probe->steps - 1];
    double t = (double)last->t, far = (double)probe->interval[1];
    samples->item = malloc(((size_t)probe->steps * PARTS + 1) * sizeof *samples->item);
    samples->count = 0;
    assert_non_null(samples->item);
    samples->hit = (double)last->distance < of->threshold + of->spread * t;
    samples->given_up = !samples->hit && t + (double)last->distance < far;
    double end = samples->hit ? t : far;
    for (int i = 0; i < probe->steps; i++) {
        double step = (double)probe->step[i].distance / PARTS;
        for (int k = 0; k < PARTS && (double)probe->step[i].t + k * step < end; k++)
            add(samples, of, ray, (double)probe->step[i].t + k * step);
    }
    add(samples, of, ray, end);
}

static double steepest(const struct samples *samples)
{
    double most = 0.0;
    for (int i = 0; i + 1 < samples->count; i++) {
        const struct cover_sample *s = &samples->item[i];
        // Between samples that are closer than this, rounding dominates the slope.
        if (s[1].t - s[0].t > 1e-6)
            most = fmax(most, fabs(s[1].d - s[0].d) / (s[1].t - s[0].t));
    }
    return most;
}

// ---- All rays ----

static void add_ray(struct bound_sums sums[2], const struct samples *samples,
                    const struct probe *probe, const float *shader)
{
    struct bound_sums *sum = &sums[samples->hit];
    struct cover_count count = cover_of(samples->item, samples->count, samples->hit);
    int least = (int)shader[2];
    double ratio = (double)probe->steps / count.least;
    sum->smallest = sum->rays == 0 ? ratio : fmin(sum->smallest, ratio);
    sum->lipschitz = fmax(sum->lipschitz, steepest(samples));
    sum->rays++;
    sum->march += probe->steps;
    sum->least += count.least;
    sum->most += count.most;
    sum->shader += least;
    sum->astray += least < count.least || least > count.most;
    sum->below += probe->steps < count.least;
    sum->given_up += samples->given_up;
    sum->differ += probe->steps != (int)shader[1];
}

static void look_at(const struct bound_case *of, const struct renderer_inputs *inputs, int pixel,
                    const float *shader, struct bound_sums sums[2])
{
    static struct probe probe; // too large for the stack
    int x = pixel % WIDTH, y = pixel / WIDTH;
    struct samples samples;
    struct mirror_ray ray = mirror_screen_ray(&inputs->camera, MIRROR_FOCAL_LENGTH,
                                              mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                                              mirror_screen_y(y + 0.5, HEIGHT));
    assert_true(renderer_probe(&gpu.renderer, inputs, x, y, &probe) && probe.steps > 0);
    sample_ray(&samples, of, ray, &probe);
    add_ray(sums, &samples, &probe, shader);
    free(samples.item);
}

void bound_measure(const struct bound_case *of, int every, struct bound_sums sums[2])
{
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    sums[0] = sums[1] = (struct bound_sums){0};
    inputs.camera = gpu_open_chapter(of->stem);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_COVER));
    float *values = gpu_numbers(&inputs);
    for (int i = 0, ray = 0; i < WIDTH * HEIGHT; i++)
        if (values[4 * i + 2] > 0.0f && ray++ % every == 0)
            look_at(of, &inputs, i, values + (size_t)4 * (size_t)i, sums);
    free(values);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
}

// ---- One ray ----

void bound_ask(double slope, double gap, double far, double threshold, int answer[2])
{
    struct renderer_inputs inputs = {.width = 4, .height = 4, .samples = 1};
    gpu_open_shader("tests/shaders/cover.frag");
    gpu_set("slope", slope);
    gpu_set("gap", gap);
    gpu_set("far", far);
    gpu_set("threshold", threshold);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_COVER));
    float *values = gpu_numbers(&inputs);
    for (int i = 0; i < 16; i++)
        for (int k = 1; k < 3; k++)
            assert_true(values[4 * i + k] == values[k]);
    answer[0] = (int)values[1];
    answer[1] = (int)values[2];
    free(values);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
}
