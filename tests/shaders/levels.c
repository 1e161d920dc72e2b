// levels.c - textures read at the level that fits a pixel's footprint, compared with the mean over
// the part of the texture that the pixel covers.
#include "lib/test.h"
#include "lib/levels.h"

static int setup(void **state)
{
    return gpu_setup(state) == 0 && levels_open() ? 0 : -1;
}

// The largest difference between two readings; it is infinity if one of them is NULL. Frees both
// readings.
static double apart(float *a, float *b)
{
    double largest = HUGE_VAL;
    if (a != NULL && b != NULL) {
        largest = 0.0;
        for (int i = 0; i < 4 * 1024; i++)
            largest = fmax(largest, fabs((double)a[i] - (double)b[i]));
    }
    free(a);
    free(b);
    return largest;
}

// The largest difference between a reading with a footprint of n x n texels and a reading at a
// level.
static double off_level(double n, double level)
{
    return apart(levels_read(LEVELS_SIDES, n, n, 1.0, 1.0),
                 levels_read(LEVELS_LEVEL, level, 0.0, 1.0, 1.0));
}

// A footprint whose side is a power of two is read at an integer level. Half a level more or less
// changes some point by more than 0.02, so the texture differs between all levels.
TEST(test_level_is_the_logarithm_of_the_texels)
{
    for (int level = 0; level <= 6; level++) {
        assert_true(off_level(exp2(level), level) < 0.002);
        assert_true(off_level(exp2(level), level + 0.5) > 0.02);
        assert_true(level == 0 || off_level(exp2(level), level - 0.5) > 0.02);
    }
    assert_true(off_level(0.25, 0.0) < 0.002); // a smaller footprint is read at level 0
}

// Without a level, a pixel shows one point of the part that it covers, so its error grows with the
// footprint. With the level that fits the footprint, the error is at most 0.67 times as large from
// 4 texels on, 0.55 times from 8 texels on, and 0.25 times from 32 texels on. A footprint four
// times as large gives a larger error at every size, and a footprint a quarter as large does so
// from 8 texels on. A footprint of about half the size, which is sharper, gives a smaller error,
// because level L blurs over more than 2^L texels.
TEST(test_level_is_nearer_to_what_is_covered)
{
    double last = 0.0;
    for (double n = 1.0; n <= 64.0; n *= 2.0) {
        double none = levels_error(n, n, 0.0, 1.0), right = levels_error(n, n, 1.0, 1.0);
        assert_true(none >= 0.0 && right >= 0.0);
        assert_true(none > last || n == 1.0);
        assert_true(right <= none * (n >= 32.0 ? 0.25 : n >= 8.0 ? 0.55 : n >= 4.0 ? 0.67 : 1.0));
        assert_true(levels_error(n, n, 4.0, 1.0) > 1.2 * right);
        assert_true(n < 8.0 || levels_error(n, n, 0.25, 1.0) > 1.2 * right);
        last = none;
    }
}

// A texel of level L is a box of w = 2^L texels, with the variance w^2 / 12 on each axis; linear
// interpolation between texels is a tent, with the variance w^2 / 6. Their sum is the variance of
// the pixel, n^2 / 12, where w is n / sqrt(3). There the error is close to its minimum.
TEST(test_best_level_is_where_the_variances_agree)
{
    for (double n = 6.0; n <= 48.0; n *= 2.0) {
        double best = levels_error(n, n, 1.0 / sqrt(3.0), 1.0);
        assert_true(best < 0.95 * levels_error(n, n, 1.0, 1.0));
        assert_true(best < 0.8 * levels_error(n, n, 0.4, 1.0));
        for (double factor = 0.4; factor < 1.2; factor += 0.1)
            assert_true(best < 1.15 * levels_error(n, n, factor, 1.0));
    }
}

// On a floor, the footprint is long and narrow, and one level must serve both sides. From 4 x 8
// texels on, the error is smaller than without a level; below that size, the level blurs more than
// it helps.
TEST(test_level_helps_on_a_floor)
{
    for (double sine = 0.5; sine >= 0.0625; sine *= 0.5)
        for (double n = 4.0; n <= 16.0; n *= 2.0)
            assert_true(levels_error(n, n / sine, 1.0, sine) <
                        0.9 * levels_error(n, n / sine, 0.0, sine));
}

// footprintOn computes the longer side, so the result is the same as with both sides given.
TEST(test_footprint_of_a_floor_is_width_over_sine)
{
    for (double sine = 1.0; sine >= 0.0625; sine *= 0.5)
        assert_true(apart(levels_read(LEVELS_FLOOR, 3.0, 3.0, 1.0, sine),
                          levels_read(LEVELS_SIDES, 3.0, 3.0 / sine, 1.0, sine)) < 0.002);
}

TESTS(setup, gpu_teardown)
