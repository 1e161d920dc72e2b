// test_scene_09.c - pixels of chapter 09 against colours computed in double precision, and its
// probe against the city's distance in double.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_city.h"
#include "support_pixels.h"

#define SHADER "chapters/09_sky_and_sunset.frag"
#define STEM   "09_sky_and_sunset"

static struct probe probe; // too large for the stack

// The hour at time 0, and at the time of the night's picture: a quarter of an hour a second.
static struct mirror_sample at_its_hour(const struct mirror_eye *eye)
{
    return city_sample(eye, 17.8 + 0.25 * eye->time);
}

static const struct mirror_picture pictures[] = {
    {"sunset", SHADER, STEM, 0.0, at_its_hour},
    {"night", SHADER, STEM, 16.8, at_its_hour},
    {"noon", SHADER, STEM, 72.8, at_its_hour},
};

static const struct pixel pixels[] = {
    {"sunset", 14, 12, "window-"},    {"sunset", 101, 12, "pavement#"},
    {"sunset", 130, 12, "pavement#"}, {"sunset", 188, 12, "road#"},
    {"sunset", 217, 12, "road#"},     {"sunset", 246, 12, "road+"},
    {"sunset", 275, 12, "road+"},     {"sunset", 565, 12, "window-"},
    {"sunset", 594, 12, "wall-"},     {"sunset", 594, 58, "wall-"},
    {"sunset", 333, 173, "sky-"},     {"sunset", 333, 196, "sky-"},
    {"night", 14, 12, "window-"},     {"night", 101, 12, "pavement#"},
    {"night", 130, 12, "pavement#"},  {"night", 188, 12, "road#"},
    {"night", 217, 12, "road#"},      {"night", 565, 12, "window+"},
    {"night", 594, 12, "wall+"},      {"night", 623, 12, "window#"},
    {"night", 14, 35, "window-"},     {"night", 565, 35, "window+"},
    {"night", 507, 58, "window#"},    {"night", 14, 81, "wall-"},
    {"night", 43, 81, "wall-"},       {"night", 507, 81, "wall#"},
    {"night", 565, 81, "wall+"},      {"night", 507, 150, "wall#"},
    {"night", 333, 173, "sky-"},      {"night", 333, 196, "sky-"},
    {"noon", 14, 12, "window-"},      {"noon", 101, 12, "pavement#"},
    {"noon", 130, 12, "pavement#"},   {"noon", 188, 12, "road#"},
    {"noon", 217, 12, "road#"},       {"noon", 565, 12, "window#"},
    {"noon", 594, 12, "wall#"},       {"noon", 623, 12, "window#"},
    {"noon", 14, 35, "window-"},      {"noon", 333, 35, "road+"},
    {"noon", 362, 35, "road+"},       {"noon", 420, 35, "pavement+"},
    {"noon", 594, 58, "wall#"},       {"noon", 14, 81, "wall-"},
    {"noon", 43, 81, "wall-"},        {"noon", 333, 173, "sky-"},
    {"noon", 333, 196, "sky-"},       {"noon", 391, 288, "wall+"},
};

static void check(int picture)
{
    // The march ends up to a pixel's width before the surface: that moves a window's rim, not its
    // middle, and the fog by less than 0.3 of 255.
    struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.6 / 255.0};
    pixels_check(&pictures[picture], &list);
}

static void test_sunset(void **unused)
{
    (void)unused;
    check(0);
}

static void test_night(void **unused)
{
    (void)unused;
    check(1);
}

static void test_noon(void **unused)
{
    (void)unused;
    check(2);
}

// Every step that --probe lists: its distance is the city's at its place, the next step stands so
// much farther, and the last one ends as the cone says.
static int check_march(const struct renderer_inputs *inputs, int x, int y)
{
    assert_true(renderer_probe(&gpu.renderer, inputs, x, y, &probe));
    double spread = 1.0 / (360.0 * MIRROR_FOCAL_LENGTH);
    for (int i = 0; i < probe.steps; i++) {
        double t = (double)probe.step[i].t, f = (double)probe.step[i].distance;
        struct d3 p = d3_of(probe.step[i].position);
        double wall_x = fabs(fabs(p.x / 6.0 - floor(p.x / 6.0)) - 0.5);
        double wall_z = fabs(fabs(p.z / 6.0 - floor(p.z / 6.0)) - 0.5);
        if (wall_x > 1e-4 && wall_z > 1e-4)
            assert_true(fabs(f - city_distance(p, NULL)) < 4e-6 * (8.0 + t));
        bool last = i == probe.steps - 1, near = f < 0.002 + spread * t;
        if (fabs(f - 0.002 - spread * t) > 1e-6 && !last)
            assert_false(near);
        if (!last)
            assert_true(fabs((double)probe.step[i + 1].t - t - f) < 1e-5 * (1.0 + t));
    }
    return probe.steps;
}

static void test_probe_walks_by_the_city(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = {.width = 640, .height = 360, .samples = 1};
    int steps = 0;
    assert_true(mirror_camera(gpu.root, STEM, &inputs.camera));
    assert_true(gpu_load(SHADER));
    for (int y = 9; y < 360; y += 18)
        for (int x = 11; x < 640; x += 37)
            steps += check_march(&inputs, x, y);
    print_message("# %d steps of 360 rays agree with the city in double\n", steps);
    assert_true(steps > 3000);
}

// Down the middle of the avenue the cap alone counts: steps of half a street.
static void test_steps_down_the_avenue(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = {
        .width = 1, .height = 1, .samples = 1, .camera = {.position = {3.0f, 5.0f, 0.0f}}};
    assert_true(gpu_load(SHADER));
    // A picture of one pixel has a wide ray: the far end of the march is not asked for here.
    assert_true(renderer_probe(&gpu.renderer, &inputs, 0, 0, &probe));
    for (int i = 0; i < probe.steps; i++)
        assert_true(fabs((double)probe.step[i].distance - 1.35) < 1e-6);
    assert_int_equal((int)ceil(80.0 / 1.35), 60);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sunset),
        cmocka_unit_test(test_night),
        cmocka_unit_test(test_noon),
        cmocka_unit_test(test_probe_walks_by_the_city),
        cmocka_unit_test(test_steps_down_the_avenue),
    };
    return cmocka_run_group_tests_name("scene 09", tests, gpu_setup, gpu_teardown);
}
