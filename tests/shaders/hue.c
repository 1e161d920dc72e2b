// hue.c - the GPU's colour of a hue compared with its piecewise definition in double precision.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

static float *values_of(int function, int rows)
{
    return gpu_call("tests/shaders/hue.frag", 1024, rows, function, (const float[4]){0});
}

// Figure 5 of the report, in pieces of 60 degrees: in each piece, one channel is 1, one is 0, and
// one changes linearly.
static struct d3 definition(double hue)
{
    double turns = floor(hue / 360.0), degrees = hue - 360.0 * turns;
    int piece = (int)(degrees / 60.0) % 6;
    double up = degrees / 60.0 - piece, down = 1.0 - up;
    switch (piece) {
    case 0:
        return d3(1.0, up, 0.0);
    case 1:
        return d3(down, 1.0, 0.0);
    case 2:
        return d3(0.0, 1.0, up);
    case 3:
        return d3(0.0, down, 1.0);
    case 4:
        return d3(up, 0.0, 1.0);
    default:
        return d3(1.0, 0.0, down);
    }
}

static double off(struct d3 a, struct d3 b)
{
    return fmax(fabs(a.x - b.x), fmax(fabs(a.y - b.y), fabs(a.z - b.z)));
}

// The largest error of a channel. A hue near 1024 degrees is rounded by up to 6e-5 degrees, a
// millionth of 60 degrees.
static double worst_hue(int function, int rows, int count)
{
    float *values = values_of(function, rows);
    double worst = 0.0;
    for (int i = 0; i < count; i++)
        worst = fmax(worst, off(d3_of(values + 4 * i + 1), definition((double)values[4 * i])));
    free(values);
    return worst;
}

TEST(test_3600_hues_match_the_definition)
{
    double worst = worst_hue(0, 4, 3600);
    print_message("# 3600 hues: worst channel off by %.2g\n", worst);
    assert_true(worst < 1e-6);
}

TEST(test_hues_of_several_turns_match_the_definition)
{
    double worst = worst_hue(1, 4, 4096);
    print_message("# -1024 to 1024 degrees: worst channel off by %.2g\n", worst);
    assert_true(worst < 2e-6);
}

TEST(test_knees_are_exact)
{
    static const float knees[7][3] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1},
                                      {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
    float *values = values_of(1, 4);
    for (int k = 0; k <= 6; k++) {
        const float *v = values + 4 * (2048 + 120 * k); // the hue of 60 k degrees
        assert_true(v[0] == 60.0f * (float)k);
        for (int channel = 0; channel < 3; channel++)
            assert_true(v[1 + channel] == knees[k][channel]);
    }
    const float *cyan = values + 4 * (2048 + 360);
    assert_true(cyan[0] == 180.0f && cyan[1] == 0.0f && cyan[2] == 1.0f && cyan[3] == 1.0f);
    free(values);
}

// The largest channel is the value, and the smallest is less than it by saturation times value.
TEST(test_saturation_and_value_set_the_channels)
{
    float *values = values_of(2, 4);
    double worst = 0.0;
    for (int i = 0; i < 4096; i++) {
        struct d3 pure = definition(0.5 * (i % 720)), white = {1.0, 1.0, 1.0};
        double saturation = i / 720 % 3 / 2.0, value = i % 5 / 4.0;
        struct d3 mixed = d3_add(d3_times(1.0 - saturation, white), d3_times(saturation, pure));
        struct d3 got = d3_of(values + 4 * i);
        worst = fmax(worst, off(got, d3_times(value, mixed)));
        double largest = fmax(got.x, fmax(got.y, got.z)), least = fmin(got.x, fmin(got.y, got.z));
        assert_true(fabs(largest - value) < 1e-6);
        assert_true(fabs(largest - least - saturation * value) < 1e-6);
    }
    free(values);
    print_message("# hue, saturation, value: worst channel off by %.2g\n", worst);
    assert_true(worst < 1e-6);
}

TESTS(gpu_setup, gpu_teardown)
