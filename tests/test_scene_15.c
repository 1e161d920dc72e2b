// test_scene_15.c - the courtyard of chapter 15 in double precision: pixels of its picture with one
// sample, a pinhole, through mist, vignette and film.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_courtyard.h"
#include "support_pixels.h"
#include "support_random.h"

#define CHAPTER "15_the_picture"

enum { WIDTH = 640, HEIGHT = 360, MAX_STEPS = 96, MIST_DIMENSION = 6, SHAFTS = 3 };

static const double threshold = 0.001, density = 0.09, scale = 1.6;
static const double pixel_spread = 1.0 / (HEIGHT * MIRROR_FOCAL_LENGTH);

static struct d3 sun_direction(void)
{
    double azimuth = 66.0 * MIRROR_PI / 180.0, up = 15.0 * MIRROR_PI / 180.0;
    return d3(cos(up) * cos(azimuth), sin(up), cos(up) * sin(azimuth));
}

static struct d3 mix(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

// ---- Mist ----

// The optical depth of a way, which the climb makes longer or shorter than at its start.
static double depth_of(struct mirror_ray ray, double t)
{
    double start = density * exp(-ray.origin.y / scale), x = ray.direction.y / scale;
    return fabs(x) > 1e-9 ? start * -expm1(-x * t) / x : start * t;
}

// The way of a depth, by halving.
static double way_of(struct mirror_ray ray, double depth, double most)
{
    double low = 0.0, high = most;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        *(depth_of(ray, middle) < depth ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

static bool over_the_side_walls(struct d3 p, struct d3 to_sun)
{
    double t = (4.75 - p.x) / to_sun.x;
    return p.y + t * to_sun.y > 3.1;
}

static bool through_the_arcade(struct d3 p, struct d3 to_sun)
{
    double t = (-4.0 - p.z) / to_sun.z, y = p.y + t * to_sun.y, x = p.x + t * to_sun.x;
    if (t < 0.0)
        return true;
    x -= 1.9 * fmin(fmax(floor(x / 1.9 + 0.5), -2.0), 2.0);
    bool opening = hypot(x, fmax(y - 2.05, 0.0)) < 0.72;
    bool ledge = fabs(x) > 0.66 && fabs(y - 2.02) < 0.06;
    return y < 3.5 && opening && !ledge;
}

// Henyey and Greenstein, 1 straight on.
static double glow(double cosine, double g)
{
    return pow((1.0 - g) * (1.0 - g) / (1.0 + g * g - 2.0 * g * cosine), 1.5);
}

// ---- Light ----

static bool sun_reaches(struct d3 p)
{
    struct mirror_ray ray = {p, sun_direction()};
    double interval[2], t = 0.0;
    if (!over_the_side_walls(p, ray.direction))
        return false;
    if (!brute_box_interval(ray, d3(-4.80, -0.01, -6.35), d3(4.80, 4.75, 1.50), interval))
        return true;
    for (int step = 0; step < MAX_STEPS && t < interval[1]; step++) {
        double h = courtyard_distance(mirror_at(ray, t), NULL);
        if (h < threshold)
            return false;
        t += h;
    }
    return true;
}

static struct d3 place_light(const struct courtyard_place *place, struct mirror_sample *sample)
{
    double facing = mirror_lambert(place->normal, sun_direction());
    struct d3 from = d3_add(place->p, d3_times(2.0 * place->radius, place->normal));
    double seen = facing > 0.0 && sun_reaches(from) ? 1.0 : 0.0;
    sample->faces = facing > 0.0;
    sample->shadowed = facing > 0.0 && seen == 0.0;
    struct d3 sky = mix(d3(0.16, 0.15, 0.16), d3(0.21, 0.34, 0.58), 0.5 + 0.5 * place->normal.y);
    sky = d3_times(0.3 + 0.7 * mirror_smoothstep(-6.2, -3.6, place->p.z), sky);
    struct d3 light = d3_add(sky, d3_times(seen * facing, d3(5.4, 3.2, 1.45)));
    return d3_product(place->colour, light);
}

static struct d3 sky_light(struct d3 direction)
{
    double up = mirror_smoothstep(0.0, 0.55, direction.y);
    struct d3 blue = mix(d3(0.60, 0.58, 0.62), d3(0.16, 0.27, 0.48), up);
    double round = glow(d3_dot(direction, sun_direction()), 0.7);
    return d3_add(blue, d3_times(round, d3(1.6, 0.95, 0.42)));
}

// ---- Film ----

static double developed(double light)
{
    double gamma = 1.45, g = pow(0.18, gamma), w = pow(8.0, gamma);
    double k = 0.82 * g * w / (0.18 * w - g), h = pow(fmin(light, 8.0), gamma);
    return h * (w + k) / (w * (h + k));
}

// Bayer's matrix by doubling: each cell of the smaller becomes four, at 0, 2, 3 and 1.
static double dither_step(int x, int y)
{
    static const int order[2][2] = {{0, 2}, {3, 1}};
    int k = 0;
    for (int bit = 0; bit < 3; bit++)
        k = 4 * k + order[(y >> bit) & 1][(x >> bit) & 1];
    return (k + 0.5) / 64.0 - 0.5;
}

static struct mirror_sample sample_15(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.what = "sky"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct courtyard_place place = courtyard_place(ray, threshold, pixel_spread, MAX_STEPS);
    double way = place.open ? 1e4 : d3_length(d3_sub(place.p, ray.origin));
    double depth = depth_of(ray, way), through = exp(-depth);
    struct d3 light = place.open ? sky_light(ray.direction) : place_light(&place, &sample);
    if (!place.open)
        sample.what = place.what;
    int x = (int)floor(0.5 * (eye->x * HEIGHT + WIDTH)),
        y = (int)floor(0.5 * (eye->y + 1.0) * HEIGHT);
    double lot = random_of(x, y, 0, MIST_DIMENSION);
    double lit = 0.0;
    for (int i = 0; i < SHAFTS; i++) {
        double share = (i + lot) / SHAFTS;
        struct d3 mist = mirror_at(ray, way_of(ray, -log(1.0 - share * (1.0 - through)), way));
        if (over_the_side_walls(mist, sun_direction()) && through_the_arcade(mist, sun_direction()))
            lit += 1.0 / SHAFTS;
    }
    double forward = glow(d3_dot(ray.direction, sun_direction()), 0.6);
    struct d3 fog = d3_add(d3(0.10, 0.16, 0.27), d3_times(lit * forward, d3(3.3, 1.90, 0.86)));
    light = mix(fog, light, through);
    double square = MIRROR_FOCAL_LENGTH * MIRROR_FOCAL_LENGTH;
    double cosine_square = square / (square + eye->x * eye->x + eye->y * eye->y);
    light = d3_times(cosine_square * cosine_square, light);
    double step = dither_step(x, y) / 255.0;
    sample.colour =
        d3(mirror_encode(developed(light.x)) + step, mirror_encode(developed(light.y)) + step,
           mirror_encode(developed(light.z)) + step);
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 326, 53, "arcade-"},  {CHAPTER, 171, 253, "arcade-"}, {CHAPTER, 338, 151, "arcade-"},
    {CHAPTER, 184, 351, "arcade-"}, {CHAPTER, 350, 249, "arcade-"}, {CHAPTER, 41, 298, "arcade-"},
    {CHAPTER, 363, 347, "arcade-"}, {CHAPTER, 66, 143, "arcade-"},  {CHAPTER, 375, 94, "jar-"},
    {CHAPTER, 412, 38, "jar-"},     {CHAPTER, 417, 108, "jar-"},    {CHAPTER, 410, 81, "jar-"},
    {CHAPTER, 101, 130, "jar-"},    {CHAPTER, 403, 54, "jar-"},     {CHAPTER, 424, 136, "paving#"},
    {CHAPTER, 498, 22, "paving#"},  {CHAPTER, 238, 112, "paving#"}, {CHAPTER, 454, 52, "paving#"},
    {CHAPTER, 533, 9, "paving#"},   {CHAPTER, 489, 38, "paving#"},  {CHAPTER, 505, 49, "paving+"},
    {CHAPTER, 554, 91, "paving+"},  {CHAPTER, 591, 34, "paving+"},  {CHAPTER, 510, 120, "paving+"},
    {CHAPTER, 547, 63, "paving+"},  {CHAPTER, 584, 7, "paving+"},   {CHAPTER, 40, 341, "roof-"},
    {CHAPTER, 24, 330, "roof-"},    {CHAPTER, 67, 344, "roof-"},    {CHAPTER, 16, 346, "roof-"},
    {CHAPTER, 9, 319, "roof-"},     {CHAPTER, 51, 333, "roof-"},    {CHAPTER, 603, 132, "side+"},
    {CHAPTER, 615, 229, "side+"},   {CHAPTER, 608, 202, "side+"},   {CHAPTER, 633, 48, "side+"},
    {CHAPTER, 601, 175, "side+"},   {CHAPTER, 595, 148, "side+"},   {CHAPTER, 208, 196, "side-"},
    {CHAPTER, 245, 139, "side-"},   {CHAPTER, 115, 184, "side-"},   {CHAPTER, 201, 169, "side-"},
    {CHAPTER, 380, 165, "side-"},   {CHAPTER, 108, 157, "side-"},   {CHAPTER, 480, 204, "sky-"},
    {CHAPTER, 492, 302, "sky-"},    {CHAPTER, 529, 245, "sky-"},    {CHAPTER, 542, 343, "sky-"},
    {CHAPTER, 387, 192, "sky-"},    {CHAPTER, 399, 290, "sky-"},    {CHAPTER, 10, 75, "steps#"},
    {CHAPTER, 47, 18, "steps#"},    {CHAPTER, 405, 11, "steps#"},   {CHAPTER, 89, 32, "steps#"},
    {CHAPTER, 131, 46, "steps#"},   {CHAPTER, 31, 7, "steps#"},     {CHAPTER, 54, 46, "steps+"},
    {CHAPTER, 233, 42, "steps+"},   {CHAPTER, 103, 87, "steps+"},   {CHAPTER, 140, 30, "steps+"},
    {CHAPTER, 226, 14, "steps+"},   {CHAPTER, 182, 44, "steps+"},   {CHAPTER, 194, 142, "tree-"},
    {CHAPTER, 206, 133, "tree-"},   {CHAPTER, 198, 112, "tree-"},   {CHAPTER, 461, 79, "well-"},
    {CHAPTER, 452, 95, "well-"},    {CHAPTER, 444, 111, "well-"},   {CHAPTER, 472, 70, "well-"},
    {CHAPTER, 471, 114, "well-"},   {CHAPTER, 464, 86, "well-"},
};

// The chapter's march begins where the gallery's air ends, this one at the eye: the hits lie within
// a threshold of each other, which no colour shows.
static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    pixels_check_chapter(CHAPTER, sample_15, pixels, sizeof pixels / sizeof *pixels);
}

// The picture in numbers before they are rounded, with a setting; the caller frees it.
static float *picture_with(const char *setting)
{
    struct renderer_inputs inputs = {.width = 80, .height = 45, .samples = 1};
    assert_true(mirror_camera(gpu.root, CHAPTER, &inputs.camera));
    assert_true(gpu_load("chapters/" CHAPTER ".frag"));
    assert_true(parameters_assign(&gpu.renderer.parameters, "dither=false"));
    assert_true(parameters_assign(&gpu.renderer.parameters, setting));
    float *values = gpu_numbers(&inputs);
    assert_non_null(values);
    return values;
}

// At 1 it is a smoothstep of what is written, not of light.
static void test_punch_is_a_contrast_of_numbers(void **unused)
{
    (void)unused;
    float *plain = picture_with("punch=0"), *punched = picture_with("punch=1");
    for (int i = 0; i < 80 * 45; i++)
        for (int k = 0; k < 3; k++) {
            double v = (double)plain[4 * i + k], right = v * v * (3.0 - 2.0 * v);
            assert_true(fabs((double)punched[4 * i + k] - right) < 1e-5);
        }
    free(plain);
    free(punched);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
        cmocka_unit_test(test_punch_is_a_contrast_of_numbers),
    };
    return cmocka_run_group_tests_name("scene of chapter 15", tests, gpu_setup, gpu_teardown);
}
