// test_benchmark_numbers.c - what --benchmark makes of its clocks, and prints.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "../common/picture/benchmark.h"
#include "support_image.h"
#include "support_scratch.h"

static void assert_spread(const double *values, int count, double least, double middle, double most)
{
    double copy[8];
    memcpy(copy, values, (size_t)count * sizeof *values);
    struct benchmark_spread spread = benchmark_spread_of(copy, count);
    if (spread.minimum != least || spread.median != middle || spread.maximum != most)
        fail_msg("%d numbers: %g, %g, %g, not %g, %g, %g", count, spread.minimum, spread.median,
                 spread.maximum, least, middle, most);
}

static void a_median_stands_in_the_middle(void **unused)
{
    (void)unused;
    const double values[] = {5.0, 40.0, 1.0, 3.0, -2.0, 100.0, 6.0};
    assert_spread(values, 1, 5.0, 5.0, 5.0);
    assert_spread(values, 2, 5.0, 22.5, 40.0);
    assert_spread(values, 3, 1.0, 5.0, 40.0);
    assert_spread(values, 4, 1.0, 4.0, 40.0);
    assert_spread(values, 5, -2.0, 3.0, 40.0);
    assert_spread(values, 7, -2.0, 5.0, 100.0);
}

static const struct benchmark numbers = {
    .shader = "a \"b\\\n",
    .backend = "none",
    .frames = 7,
    .inputs = {.width = 30, .height = 20, .time = 1.5, .samples = 3},
    .compile = {{0.5, 0.25, 0.0}},
    .first = {{0.125, 0.0625, 0.0}},
    .median = {{0.002, 0.003, 0.0}},
    .minimum = {{0.001, 0.0015, 0.0}},
    .maximum = {{0.004, 0.006, 0.0}},
    .has_evaluations = true,
    .mean = 12.5,
    .percentile = 40.0,
    .most = 99.0,
    .cover = {.rays = 11, .march = 9.0, .bound = 6.0, .ratio = 1.5, .ray_ratio = 1.25},
};

// Print into a file of the folder, and read that.
static const char *printed(bool json)
{
    static unsigned char text[8192];
    const char *path = scratch_path("numbers");
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    benchmark_print(&numbers, json, file);
    assert_int_equal(fclose(file), 0);
    text[picture_bytes(path, text, sizeof text - 1)] = '\0';
    return (const char *)text;
}

static void assert_says(const char *text, const char *wanted)
{
    if (strstr(text, wanted) == NULL)
        fail_msg("no '%s' in\n%s", wanted, text);
}

static void every_number_stands_at_its_name(void **unused)
{
    (void)unused;
    const char *text = printed(false);
    assert_says(text, "picture        30x20, time 1.5 s, samples a pixel: 9, frames: 7\n");
    assert_says(text, "cold compile      500.000    250.000\n");
    assert_says(text, "first frame       125.000     62.500\n");
    assert_says(text, "frame, median       2.000      3.000\n");
    assert_says(text, "minimum             1.000      1.500\n");
    assert_says(text, "maximum             4.000      6.000\n");
    assert_says(text, "mean 12.50, 99 % of the pixels at most 40, maximum 99\n");
    assert_says(text, "9.00 evaluations a ray, the least 6.00: march / bound 1.50, of one ray at "
                      "least 1.25; rays: 11\n");
    text = printed(true);
    assert_says(text, "  \"shader\": \"a \\\"b\\\\?\",\n");
    assert_says(text, "  \"compile_cpu_ms\": 500.0000,\n  \"compile_wall_ms\": 250.0000,\n"
                      "  \"compile_gpu_ms\": null,\n");
    assert_says(text, "  \"frame_median_cpu_ms\": 2.0000,\n");
    assert_says(text, "  \"frame_minimum_wall_ms\": 1.5000,\n");
    assert_says(text, "  \"frame_maximum_wall_ms\": 6.0000,\n");
    assert_says(text, "  \"evaluations_p99\": 40,\n  \"evaluations_maximum\": 99,\n");
    assert_says(text, "  \"march_over_bound_minimum\": 1.2500\n}\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_median_stands_in_the_middle),
        cmocka_unit_test_setup_teardown(every_number_stands_at_its_name, scratch_setup,
                                        scratch_teardown),
    };
    return cmocka_run_group_tests_name("benchmark numbers", tests, NULL, NULL);
}
