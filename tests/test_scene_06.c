// test_scene_06.c - the pyramid of chapter 06 in double precision: pixels of its picture, and the
// tables of --probe, step by step.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_pixels.h"
#include "support_pyramid.h"

#define CHAPTER "06_sierpinski_symmetry"
#define SIZE    PYRAMID_SIZE
#define MARGIN  0.02

enum { WIDTH = 640, HEIGHT = 360, MAX_STEPS = 160 };

static const double hit_threshold = 0.0002, normal_step = 0.0005;
static const double spread = 1.5 / (HEIGHT * MIRROR_FOCAL_LENGTH);

static struct probe probe; // too large for the stack

// ---- Where a ray is looked at ----

static bool pyramid_interval(struct mirror_ray ray, double t[2])
{
    struct tetrahedron pyramid = pyramid_whole();
    t[0] = 0.0;
    t[1] = 1e9;
    for (int k = 0; k < 4; k++) {
        double height = pyramid_face(&pyramid, k, ray.origin) - MARGIN;
        double rate = d3_dot(ray.direction, pyramid_normal(&pyramid, k));
        if (rate < 0.0)
            t[0] = fmax(t[0], -height / rate);
        else
            t[1] = fmin(t[1], -height / rate);
    }
    return t[0] < t[1];
}

static void scene_interval(struct mirror_ray ray, double t[2])
{
    double a[2], b[2];
    struct d3 margin = d3(MARGIN, MARGIN, MARGIN), half = d3_add(pyramid_slab_half, margin);
    bool in_a = pyramid_interval(ray, a);
    bool in_b = brute_box_interval(ray, d3_sub(pyramid_slab, half), d3_add(pyramid_slab, half), b);
    t[0] = fmin(in_a ? a[0] : HUGE_VAL, in_b ? b[0] : HUGE_VAL);
    t[1] = fmax(in_a ? a[1] : -1.0, in_b ? b[1] : -1.0);
}

static bool march_cone(struct mirror_ray ray, const double interval[2], double *t)
{
    *t = interval[0];
    for (int steps = 0; steps < MAX_STEPS && *t < interval[1]; steps++) {
        double distance = mirror_distance(&pyramid_scene, mirror_at(ray, *t), NULL);
        if (distance < hit_threshold + spread * *t)
            return true;
        *t += distance;
    }
    return false;
}

// ---- Colours ----

static struct d3 mix(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

static struct d3 wide_normal(struct d3 p, double h)
{
    double g[3];
    for (int k = 0; k < 3; k++) {
        struct d3 step = d3(k == 0 ? h : 0.0, k == 1 ? h : 0.0, k == 2 ? h : 0.0);
        g[k] = mirror_distance(&pyramid_scene, d3_add(p, step), NULL) -
               mirror_distance(&pyramid_scene, d3_sub(p, step), NULL);
    }
    return d3_unit(d3(g[0], g[1], g[2]));
}

static void fold_trail(struct d3 p, double *inner, double *open)
{
    struct tetrahedron t = pyramid_whole();
    double size = SIZE, digit = 0.5;
    *inner = 0.0;
    *open = 1.0;
    for (int i = 0; i < 4; i++) {
        *open *= 1.0 + fmin(1.5 * pyramid_planes(&t, p) / size, 0.0);
        *inner += pyramid_fold(&t, &p) ? digit : 0.0;
        size *= 0.5;
        digit *= 0.5;
    }
}

// One channel of a pure hue, from the curve's knees.
static double hue_channel(double hue, double peak)
{
    double away = fabs(remainder(hue - peak, 360.0));
    return mirror_clamp((120.0 - away) / 60.0);
}

static struct d3 stone_colour(double inner)
{
    double hue = 46.0 - 60.0 * inner;
    struct d3 pure = d3(hue_channel(hue, 0.0), hue_channel(hue, 120.0), hue_channel(hue, 240.0));
    return d3_times(0.85, mix(d3(1.0, 1.0, 1.0), pure, 0.5));
}

static struct d3 sun_direction(double time)
{
    double azimuth = (160.0 + 8.0 * time) * MIRROR_PI / 180.0, up = 28.0 * MIRROR_PI / 180.0;
    return d3(cos(up) * cos(azimuth), sin(up), cos(up) * sin(azimuth));
}

static struct d3 sky_light(struct d3 direction, struct d3 to_sun)
{
    double facing = 0.5 + 0.5 * d3_dot(direction, to_sun), y = direction.y;
    struct d3 band = mix(d3(0.09, 0.10, 0.20), d3(1.40, 0.58, 0.16), facing * facing);
    struct d3 sky = mix(band, d3(0.008, 0.024, 0.085), mirror_smoothstep(0.0, 0.36, y));
    return mix(d3(0.05, 0.065, 0.12), sky, mirror_smoothstep(-0.14, 0.06, y));
}

// The share of the sun that arrives.
static double sun_share(struct mirror_ray ray, double threshold)
{
    double t[2], smallest = 1.0;
    if (!pyramid_interval(ray, t))
        return 1.0;
    for (int steps = 0; steps < MAX_STEPS && t[0] < t[1] && smallest > 0.2; steps++) {
        double distance = mirror_distance(&pyramid_scene, mirror_at(ray, t[0]), NULL);
        smallest = fmin(smallest, distance / (threshold + 0.02 * t[0]));
        t[0] += distance;
    }
    return fmax((smallest - 0.2) / 0.8, 0.0);
}

// The share of a pixel that the joints of one direction cover, along x or along z: the pixel covers
// [at - reach, at + reach].
static double joint_share(double at, double reach)
{
    const double tile = 0.5, half = 0.008;
    double away = fabs(remainder(at, tile));
    return fmax((fmin(away + reach, half) - fmax(away - reach, -half)) / (2.0 * reach), 0.0);
}

static struct d3 slab_colour(struct d3 p, struct d3 direction, double radius)
{
    double x = joint_share(p.x, radius * (1.0 + fabs(direction.x / direction.y)));
    double z = joint_share(p.z, radius * (1.0 + fabs(direction.z / direction.y)));
    return d3_times(1.0 - 0.5 * fmax(x, z), d3(0.12, 0.13, 0.16));
}

static struct d3 surface_light(struct mirror_ray ray, double t, struct d3 to_sun,
                               struct mirror_sample *sample)
{
    struct d3 p = mirror_at(ray, t);
    double radius = hit_threshold + spread * t, step = normal_step + spread * t;
    double inner, open, height = mirror_box(d3_sub(p, pyramid_slab), pyramid_slab_half);
    struct d3 normal = wide_normal(p, step);
    fold_trail(p, &inner, &open);
    double facing = mirror_lambert(normal, to_sun), share = 1.0;
    if (facing > 0.0)
        share = sun_share((struct mirror_ray){d3_add(p, d3_times(2.0 * radius, normal)), to_sun},
                          radius);
    struct d3 ambient =
        mix(d3(0.03, 0.03, 0.04), d3(0.12, 0.20, 0.38), (0.5 + 0.5 * normal.y) * open);
    struct d3 light = d3_add(ambient, d3_times(share * facing, d3(1.22, 0.65, 0.20)));
    bool stone = height >= radius;
    sample->what = stone ? "stone" : "slab";
    sample->faces = !stone && share > 0.5; // stone turns from pixel to pixel: no such place lasts
    sample->shadowed = !stone && share <= 0.5;
    return d3_product(stone ? stone_colour(inner) : slab_colour(p, ray.direction, radius), light);
}

static struct mirror_sample sample_06(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.what = "sky"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct d3 to_sun = sun_direction(eye->time);
    struct d3 light = sky_light(ray.direction, to_sun);
    double interval[2], t;
    scene_interval(ray, interval);
    if (march_cone(ray, interval, &t))
        light = surface_light(ray, t, to_sun, &sample);
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 624, 189, "sky-"},   {CHAPTER, 327, 210, "sky-"},   {CHAPTER, 222, 153, "sky-"},
    {CHAPTER, 246, 318, "sky-"},   {CHAPTER, 438, 54, "slab+"},   {CHAPTER, 39, 69, "slab+"},
    {CHAPTER, 33, 24, "slab+"},    {CHAPTER, 330, 15, "slab+"},   {CHAPTER, 378, 12, "slab+"},
    {CHAPTER, 492, 6, "slab+"},    {CHAPTER, 573, 54, "slab+"},   {CHAPTER, 471, 81, "slab+"},
    {CHAPTER, 396, 39, "slab+"},   {CHAPTER, 435, 111, "slab#"},  {CHAPTER, 387, 111, "slab#"},
    {CHAPTER, 348, 60, "slab#"},   {CHAPTER, 363, 81, "slab#"},   {CHAPTER, 417, 99, "slab#"},
    {CHAPTER, 414, 102, "slab#"},  {CHAPTER, 357, 87, "slab#"},   {CHAPTER, 120, 93, "stone-"},
    {CHAPTER, 246, 210, "stone-"}, {CHAPTER, 303, 78, "stone-"},  {CHAPTER, 207, 228, "stone-"},
    {CHAPTER, 264, 69, "stone-"},  {CHAPTER, 228, 90, "stone-"},  {CHAPTER, 288, 84, "stone-"},
    {CHAPTER, 252, 300, "stone-"}, {CHAPTER, 297, 48, "stone-"},  {CHAPTER, 219, 228, "stone-"},
    {CHAPTER, 303, 150, "stone-"}, {CHAPTER, 195, 219, "stone-"}, {CHAPTER, 207, 90, "stone-"},
    {CHAPTER, 240, 216, "stone-"}, {CHAPTER, 315, 90, "stone-"},  {CHAPTER, 294, 81, "stone-"},
    {CHAPTER, 243, 78, "stone-"},  {CHAPTER, 156, 96, "stone-"},  {CHAPTER, 201, 93, "stone-"},
    {CHAPTER, 156, 150, "stone-"}, {CHAPTER, 273, 252, "stone-"}, {CHAPTER, 240, 201, "stone-"},
    {CHAPTER, 258, 240, "stone-"}, {CHAPTER, 258, 237, "stone-"}, {CHAPTER, 264, 258, "stone-"},
    {CHAPTER, 228, 102, "stone-"}, {CHAPTER, 231, 66, "stone-"},  {CHAPTER, 282, 234, "stone-"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    pixels_check_chapter(CHAPTER, sample_06, pixels, sizeof pixels / sizeof *pixels);
}

// ---- The table of --probe ----

// What the rounding of a few dozen operations on numbers of a few units may do.
static const double slack = 4e-6;

static void check_table(struct mirror_ray ray, const double interval[2], int *hits)
{
    double t = probe.steps > 0 ? (double)probe.step[0].t : 0.0;
    assert_true((probe.steps > 0) == (interval[0] < interval[1]) ||
                fabs(interval[1] - interval[0]) < slack);
    if (probe.steps == 0)
        return;
    assert_true(fabs(t - interval[0]) <= slack);
    for (int k = 0; k < probe.steps; k++) {
        const struct probe_step *row = &probe.step[k];
        double truth = mirror_distance(&pyramid_scene, mirror_at(ray, (double)row->t), NULL);
        double over = (double)row->distance - hit_threshold - spread * (double)row->t;
        bool last = k == probe.steps - 1;
        assert_true(fabs((double)row->distance - truth) <= slack);
        assert_true(fabs((double)row->t - t) <= slack);
        assert_true((over < 0.0) == (last && probe.end == PROBE_HIT) || fabs(over) < slack);
        t = (double)row->t + (double)row->distance;
    }
    if (probe.end == PROBE_PASSED)
        assert_true(t >= interval[1] - slack);
    *hits += probe.end == PROBE_HIT;
}

static void test_probe_is_the_march_in_double(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    assert_true(mirror_camera(gpu.root, CHAPTER, &inputs.camera));
    assert_true(gpu_load("chapters/" CHAPTER ".frag"));
    int hits = 0, rays = 0, steps = 0;
    for (int y = 8; y < HEIGHT; y += 20)
        for (int x = 10; x < WIDTH; x += 31, rays++) {
            struct mirror_ray ray = mirror_screen_ray(&inputs.camera, MIRROR_FOCAL_LENGTH,
                                                      mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                                                      mirror_screen_y(y + 0.5, HEIGHT));
            double interval[2];
            scene_interval(ray, interval);
            assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
            check_table(ray, interval, &hits);
            steps += probe.steps;
        }
    print_message("# %d rays, %d steps, %d hits\n", rays, steps, hits);
    assert_true(hits > 100 && hits < rays - 100 && steps > 800);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
        cmocka_unit_test(test_probe_is_the_march_in_double),
    };
    return cmocka_run_group_tests_name("scene of chapter 06", tests, gpu_setup, gpu_teardown);
}
