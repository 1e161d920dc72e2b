// test_scene_14.c - the courtyard of chapter 14 in double precision: pixels of its picture, by five
// taps and by many rays.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_courtyard.h"
#include "support_pixels.h"

#define CHAPTER "14_occlusion"

enum { MAX_STEPS = 96 };

static const double threshold = 0.0005, reach = 5.0;
static const double pixel_spread = 1.0 / (360.0 * MIRROR_FOCAL_LENGTH);

// All that hides the sky.
static double all_distance(struct d3 p)
{
    return fmin(courtyard_distance(p, NULL), courtyard_trough(p));
}

static double open_by_taps(struct d3 p, struct d3 normal)
{
    double hidden = 0.0;
    for (int i = 0; i < 5; i++) {
        double height = reach / pow(2.0, 4 - i);
        struct d3 tap = d3_add(p, d3_times(height, normal));
        hidden += mirror_clamp(1.0 - all_distance(tap) / height) / 5.0;
    }
    return 0.5 * (1.0 + normal.y) * (1.0 - hidden);
}

// One channel of the light that is sent back however often.
static double with_bounces(double open, double colour)
{
    return open / (1.0 - colour * (1.0 - open));
}

static struct d3 sky_light(struct d3 direction)
{
    double up = fmax(direction.y, 0.0);
    struct d3 tint =
        d3_add(d3_times(1.0 - up, d3(0.70, 0.73, 0.76)), d3_times(up, d3(0.80, 0.85, 0.90)));
    return d3_times(0.62 + 0.9 * up, tint);
}

static struct mirror_sample sample_14(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.what = "sky"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct courtyard_place place = courtyard_place(ray, threshold, pixel_spread, MAX_STEPS);
    struct d3 light = sky_light(ray.direction);
    if (!place.open) {
        double open = open_by_taps(place.p, place.normal);
        struct d3 fallen = d3(1.18 * with_bounces(open, 0.66), 1.22 * with_bounces(open, 0.56),
                              1.26 * with_bounces(open, 0.46));
        light = d3_product(place.colour, fallen);
        sample.what = place.what;
    }
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 3, 3, "paving-"},     {CHAPTER, 481, 204, "side-"},   {CHAPTER, 326, 52, "paving-"},
    {CHAPTER, 493, 303, "sky-"},    {CHAPTER, 183, 353, "sky-"},    {CHAPTER, 27, 200, "side-"},
    {CHAPTER, 506, 48, "paving-"},  {CHAPTER, 350, 250, "arcade-"}, {CHAPTER, 195, 97, "paving-"},
    {CHAPTER, 40, 299, "sky-"},     {CHAPTER, 518, 147, "side-"},   {CHAPTER, 363, 349, "sky-"},
    {CHAPTER, 207, 196, "rear-"},   {CHAPTER, 52, 44, "paving-"},   {CHAPTER, 531, 246, "side-"},
    {CHAPTER, 375, 94, "paving-"},  {CHAPTER, 388, 192, "rear-"},   {CHAPTER, 555, 90, "side-"},
    {CHAPTER, 244, 139, "steps-"},  {CHAPTER, 257, 238, "arcade-"}, {CHAPTER, 101, 86, "well-"},
    {CHAPTER, 425, 135, "tree-"},   {CHAPTER, 437, 234, "arcade-"}, {CHAPTER, 151, 127, "well-"},
    {CHAPTER, 163, 226, "arcade-"}, {CHAPTER, 331, 123, "steps-"},  {CHAPTER, 200, 169, "rear-"},
    {CHAPTER, 213, 268, "roof-"},   {CHAPTER, 57, 115, "well-"},    {CHAPTER, 381, 165, "jar-"},
    {CHAPTER, 70, 214, "well-"},    {CHAPTER, 393, 264, "roof-"},   {CHAPTER, 238, 111, "steps-"},
    {CHAPTER, 418, 108, "tree-"},   {CHAPTER, 430, 206, "arcade-"}, {CHAPTER, 144, 100, "well-"},
    {CHAPTER, 467, 149, "tree-"},   {CHAPTER, 156, 199, "arcade-"}, {CHAPTER, 336, 195, "rear-"},
    {CHAPTER, 193, 141, "steps-"},  {CHAPTER, 206, 240, "arcade-"}, {CHAPTER, 374, 137, "jar-"},
    {CHAPTER, 280, 126, "steps-"},  {CHAPTER, 460, 122, "tree-"},   {CHAPTER, 162, 270, "roof-"},
    {CHAPTER, 330, 167, "rear-"},   {CHAPTER, 342, 266, "roof-"},   {CHAPTER, 186, 114, "steps-"},
    {CHAPTER, 453, 94, "tree-"},    {CHAPTER, 401, 140, "jar-"},    {CHAPTER, 392, 156, "jar-"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    const struct mirror_picture picture = {.name = CHAPTER,
                                           .shader = "chapters/" CHAPTER ".frag",
                                           .chapter = CHAPTER,
                                           .sample = sample_14};
    const struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.1 / 255.0};
    pixels_check(&picture, &list);
}

// The shader's trough and things by another road: points of a grid, and the distance nowhere grows
// faster than one moves.
static void test_the_distance_is_1_lipschitz(void **unused)
{
    (void)unused;
    for (int i = 0; i < 40000; i++) {
        struct d3 p = d3(-4.7 + 9.4 * fmod(0.754877666 * i, 1.0), 4.7 * fmod(0.569840291 * i, 1.0),
                         -6.1 + 7.5 * fmod(0.3819660113 * i, 1.0));
        struct d3 step = d3(0.02 * cos(i), 0.02 * sin(1.7 * i), 0.02 * sin(i));
        double change = all_distance(d3_add(p, step)) - all_distance(p);
        assert_true(fabs(change) <= d3_length(step) + 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
        cmocka_unit_test(test_the_distance_is_1_lipschitz),
    };
    return cmocka_run_group_tests_name("scene of chapter 14", tests, gpu_setup, gpu_teardown);
}
