// lens.c - shaders/lens.glsl, samples.glsl and filter.glsl: rays of a thin lens compared with
// similar triangles in double precision, the cells of the samples, and the densities of the three
// filters.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define SHADER "tests/shaders/lens.frag"

enum { RAYS, CONFUSION, CELLS, SQUARES, SHARES, PAIRS, OFFSETS };

// The means of a function of the shader with this many samples along each side of a pixel. The
// caller frees them.
static float *means(int width, int height, int samples, int function, const float numbers[4])
{
    struct renderer_inputs inputs = gpu_inputs(width, height, samples);
    inputs.time = function;
    memcpy(inputs.mouse, numbers, sizeof inputs.mouse);
    return gpu_numbers(&inputs);
}

// ---- The lens ----

// All rays that the lens sends towards a point in focus meet at this point; at other depths, they
// are as far apart as the cone from the lens to the point is wide.
TEST(rays_meet_in_the_plane_in_focus)
{
    static const double depths[] = {4.0, 1.0, 2.5, 9.0, 40.0};
    const double radius = 0.2, focus = 4.0;
    for (int k = 0; k < 5; k++) {
        const float numbers[4] = {(float)radius, (float)focus, (float)depths[k]};
        assert_true(gpu_load(SHADER));
        float *values = means(16, 16, 1, RAYS, numbers);
        double scale = depths[k] / 2.0, worst = 0.0, wide = radius * (1.0 - depths[k] / focus);
        for (int i = 0; i < 256; i++) {
            const float *v = values + 4 * i;
            worst = fmax(worst, fabs((double)v[0] - 0.3 * scale - wide * (double)v[2]));
            worst = fmax(worst, fabs((double)v[1] + 0.4 * scale - wide * (double)v[3]));
        }
        free(values);
        assert_true(worst < 2e-6 * depths[k]);
    }
}

// The diameter of the circle of confusion of a point. The lines from the rim of the lens through
// the point meet the plane in focus in a circle, whose image on the screen is scaled by focal
// length / focus.
static double confusion_of(double depth, double radius, double focus, double focal)
{
    double low = 0.0, high = 0.0;
    for (int i = 0; i < 360; i++) {
        double from = radius * cos(i * MIRROR_PI / 180.0), at = 0.0;
        double there = from + (at - from) * focus / depth;
        low = fmin(low, there);
        high = fmax(high, there);
    }
    return (high - low) * focal / focus;
}

TEST(a_point_out_of_focus_is_a_disc)
{
    static const float lenses[][4] = {
        {0.03f, 4.5f, 2.0f}, {0.3f, 1.0f, 8.0f}, {0.01f, 40.0f, 1.4f}};
    for (int k = 0; k < 3; k++) {
        float *values = gpu_call(SHADER, 400, 1, CONFUSION, lenses[k]);
        for (int i = 0; i < 400; i++) {
            const float *v = values + 4 * i;
            double right =
                confusion_of((double)v[0], (double)lenses[k][0], (double)lenses[k][1], 2.0);
            assert_true(fabs((double)v[1] - right) < 2e-6);
            assert_true(fabs((double)v[2] - 0.012 / (double)lenses[k][2]) < 1e-8);
        }
        free(values);
    }
}

// ---- Samples ----

TEST(every_cell_has_one_sample)
{
    assert_true(gpu_load(SHADER));
    for (int samples = 1; samples <= 8; samples++)
        for (int cell = 0; cell < samples * samples; cell++) {
            const float numbers[4] = {(float)cell};
            float *values = means(16, 8, samples, CELLS, numbers);
            for (int i = 0; i < 16 * 8; i++)
                for (int k = 0; k < 3; k++)
                    assert_true(fabs((double)values[4 * i + k] * samples * samples - 1.0) < 1e-4);
            free(values);
        }
}

TEST(samples_lie_in_their_cells)
{
    assert_true(gpu_load(SHADER));
    const float none[4] = {0.0f};
    for (int samples = 1; samples <= 8; samples++) {
        float *values = means(64, 64, samples, SQUARES, none);
        double sum[2] = {0.0}, disc = 0.0;
        for (int i = 0; i < 64 * 64; i++) {
            sum[0] += (double)values[4 * i] / 4096.0;
            sum[1] += (double)values[4 * i + 1] / 4096.0;
            disc += (double)values[4 * i + 3] / 4096.0;
            assert_true(fabs((double)values[4 * i + 2] - 1.0) < 1e-6);
            assert_true(samples > 1 || (values[4 * i] == 0.5f && values[4 * i + 3] == 0.0f));
        }
        free(values);
        assert_true(fabs(sum[0] - 0.5) < 0.01 && fabs(sum[1] - 0.5) < 0.01 && fabs(disc) < 0.02);
    }
}

// Two quantities are sampled together, each in cells. Over many pixels, their joint distribution
// must be that of two independent random numbers: the corner of the square below x + y = 1/2 is an
// eighth of the square. With a single sample in each of 4,096 pixels, three standard deviations
// would be 3 sqrt(7/64 / 4096) = 0.0155.
TEST(pairs_are_sampled_without_bias)
{
    assert_true(gpu_load(SHADER));
    const float none[4] = {0.0f};
    for (int samples = 2; samples <= 8; samples++) {
        float *values = means(64, 64, samples, PAIRS, none);
        double sum[4] = {0.0};
        for (int i = 0; i < 4 * 64 * 64; i++)
            sum[i % 4] += (double)values[i] / 4096.0;
        free(values);
        for (int k = 0; k < 4; k++)
            assert_true(fabs(sum[k] - 0.125) < 0.0155);
    }
}

// ---- Filters ----

TEST(shares_are_those_of_tent_and_gaussian)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 1024, 1, SHARES, none);
    double tent = 0.0, gaussian = 0.0;
    for (int i = 0; i < 1024; i++) {
        double share = (double)values[4 * i], x = (double)values[4 * i + 1];
        double below = x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
        tent = fmax(tent, fabs(below - share));
        gaussian = fmax(gaussian, fabs(0.5 * erfc(-(double)values[4 * i + 2] / sqrt(2.0)) - share));
        assert_true(values[4 * i + 3] == 0.0f);
    }
    free(values);
    print_message("# shares: tent off by at most %.2g, Gaussian by at most %.2g\n", tent, gaussian);
    assert_true(tent < 1e-6 && gaussian < 5e-4);
}

// The share of a filter that is below x; and the x of a given share, found by bisection.
static double share_below(int kernel, double x)
{
    if (kernel == 0)
        return mirror_clamp(x + 0.5);
    if (kernel == 2)
        return 0.5 * erfc(-x / 0.5 / sqrt(2.0));
    double side = fmax(1.0 - fabs(x), 0.0);
    return x < 0.0 ? 0.5 * side * side : 1.0 - 0.5 * side * side;
}

static double offset_of(int kernel, double share)
{
    double low = -4.0, high = 4.0;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        *(share_below(kernel, middle) < share ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

// The mean square of count positions, each in the middle of one of count equal shares of the
// filter.
static double mean_square(int kernel, int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++)
        sum += pow(offset_of(kernel, (i + 0.5) / count), 2.0) / count;
    return sum;
}

// No filter shifts the picture, and a single sample is at the pixel's centre. Regular positions are
// in the middle of equal shares; jittered positions have the variance of the filter: 1/12, 1/6 or
// 1/4.
TEST(filters_are_centred_and_as_wide_as_said)
{
    static const double variances[] = {1.0 / 12.0, 1.0 / 6.0, 0.25};
    assert_true(gpu_load(SHADER));
    for (int kernel = 0; kernel < 3; kernel++)
        for (int jitter = 0; jitter < 2; jitter++) {
            const float numbers[4] = {(float)kernel, (float)jitter};
            float *one = means(8, 8, 1, OFFSETS, numbers),
                  *many = means(32, 32, 8, OFFSETS, numbers);
            double sum[4] = {0.0}, right = jitter ? variances[kernel] : mean_square(kernel, 8);
            for (int i = 0; i < 64; i++)
                assert_true(fabsf(one[4 * i]) < 1e-5f && fabsf(one[4 * i + 1]) < 1e-5f);
            for (int i = 0; i < 32 * 32 * 4; i++)
                sum[i % 4] += (double)many[i] / 1024.0;
            free(one);
            free(many);
            assert_true(fabs(sum[0]) < 0.003 && fabs(sum[1]) < 0.003);
            for (int k = 2; k < 4; k++)
                assert_true(fabs(sum[k] / right - 1.0) < (jitter ? 0.02 : 0.003));
        }
}

TESTS(gpu_setup, gpu_teardown)
