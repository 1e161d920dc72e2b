// test_cells.c - the operators of shaders/repetition.glsl at given numbers against their
// definitions, and the cell's hash: to the bit, and as chance.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_cell.h"
#include "support_gpu.h"

#define SHADER "tests/shaders/repetition.frag"

enum { WIDE = 256, ROWS = 64, ITEMS = WIDE * ROWS, SIDE = 256 };

// What the Time of tests/shaders/repetition.frag chooses.
enum { NUMBERS = 20, MORE_NUMBERS, LIMITED_NUMBERS, HASH };

struct period_limits {
    float period, reach, first, last;
};

static const struct period_limits all_periods[] = {{2.0f, 0.75f, -3.0f, 5.0f},
                                                   {2.5f, 1.0f, 0.0f, 0.0f},
                                                   {0.75f, 0.25f, -7.0f, -2.0f},
                                                   {5.5f, 0.625f, 4.0f, 9.0f}};

static float *numbers_of(int function, const struct period_limits *limits)
{
    return gpu_call(SHADER, WIDE, ROWS, function,
                    (const float[4]){limits->period, limits->reach, limits->first, limits->last});
}

// A place on a wall belongs to either cell: rounding chooses.
static bool on_wall(double x, double period)
{
    return fabs(fabs(x - period * floor(x / period)) - 0.5 * period) < 1e-4;
}

static double fold(double x, double period)
{
    long cell = lround(x / period);
    return (cell % 2 == 0 ? 1.0 : -1.0) * (x - period * (double)cell);
}

static void check_near(float got, double expected)
{
    assert_true(fabs((double)got - expected) < 2e-4 &&
                fabs((double)got - expected) <= 2e-7 * 600.0);
}

static void test_operators_agree_with_double(void **unused)
{
    (void)unused;
    for (int k = 0; k < 4; k++) {
        double period = (double)all_periods[k].period, reach = (double)all_periods[k].reach;
        float *first = numbers_of(NUMBERS, &all_periods[k]);
        float *second = numbers_of(MORE_NUMBERS, &all_periods[k]);
        int walls = 0;
        for (int i = 0; i < ITEMS; i++) {
            const float *v = first + 4 * i, *w = second + 4 * i;
            double x = (double)v[0], cell = (double)v[1], local = (double)v[2];
            assert_true(cell == floor(cell) && fabs(local) <= 0.5 * period + 1.2e-4);
            check_near(v[2], x - period * cell);
            check_near(v[3], fold(x, period));
            check_near(w[1], 0.5 * period + fabs(local));
            check_near(w[2], period - fabs(local) - reach);
            assert_true(fabs((double)w[0] - cell) == 1.0 && ((double)w[0] - cell) * local >= 0.0);
            walls += on_wall(x, period);
            if (!on_wall(x, period))
                assert_true(cell == floor(x / period + 0.5));
        }
        free(first);
        free(second);
        assert_true(walls > 100);
    }
}

static void test_limited_operators_agree_with_double(void **unused)
{
    (void)unused;
    for (int k = 0; k < 4; k++) {
        double period = (double)all_periods[k].period;
        double low = (double)all_periods[k].first, high = (double)all_periods[k].last;
        float *values = numbers_of(LIMITED_NUMBERS, &all_periods[k]);
        for (int i = 0; i < ITEMS; i++) {
            const float *v = values + 4 * i;
            double x = 0.0625 * (i - 8192), cell = fmin(fmax(floor(x / period + 0.5), low), high);
            double next = cell + (x < period * cell ? -1.0 : 1.0);
            if (on_wall(x, period) || fabs(x - period * cell) < 1e-4)
                continue;
            assert_true((double)v[0] == cell && (double)v[2] == fmin(fmax(next, low), high));
            check_near(v[1], x - period * cell);
            check_near(v[3], 0.5 * period + fabs(x - period * cell));
        }
        free(values);
    }
}

// GLSL's mod takes the floor of the quotient, C's fmod cuts it: they differ for negative numbers.
static void test_mod_is_not_fmod(void **unused)
{
    (void)unused;
    const struct period_limits two = {2.0f, 0.0f, 0.0f, 0.0f};
    float *values = numbers_of(MORE_NUMBERS, &two);
    int differ = 0;
    for (int i = 0; i < ITEMS; i++) {
        double x = 0.0625 * (i - 8192), mod = x - 2.0 * floor(x / 2.0);
        assert_true((double)values[4 * i + 3] == mod);
        differ += fmod(x, 2.0) != mod;
        assert_true(x < 0.0 || fmod(x, 2.0) == mod);
    }
    free(values);
    assert_true(differ > ITEMS / 3);
    assert_true(fmod(-0.5, 2.0) == -0.5 && (-1) / 2 == 0 && -1 % 2 == -1);
}

// The report's formula never comes nearer to 0 than half a period.
static void test_the_reports_formula_misses_the_middle(void **unused)
{
    (void)unused;
    for (int i = -4000; i < 4000; i++) {
        double x = 0.0101 * i, half = 2.75;
        double report = x - half - 5.5 * floor((x - half) / 5.5) + half;
        double right = x + half - 5.5 * floor((x + half) / 5.5) - half;
        assert_true(report >= half && report < 3.0 * half && fabs(right) <= half);
    }
}

// ---- The hash ----

static float *hashes(float slice)
{
    return gpu_call(SHADER, SIDE, SIDE, HASH, (const float[4]){slice});
}

static void test_hash_is_the_same_to_the_bit(void **unused)
{
    (void)unused;
    const int slices[] = {0, -1, 77};
    for (int k = 0; k < 3; k++) {
        float *values = hashes((float)slices[k]);
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE - 128, y = slices[k], z = i / SIDE - 128;
            const float *v = values + 4 * i;
            assert_true((double)v[0] == cell_hash(x, y, z) && (double)v[1] == cell_hash(z, x, y));
            assert_true((double)v[2] == cell_hash(y, z, x));
            assert_true((double)v[3] == cell_hash(8191 * x, 8191 * y, 8191 * z));
            assert_true(cell_hash(x, z, y) == (double)v[0]); // as the header says
        }
        free(values);
    }
    assert_true(cell_hash(0, 0, 0) >= 0.0 && cell_hash(1, 2, 3) < 1.0);
}

// The part of a hash that chapter 07 uses: all of it, or what stands behind 6 or 12 bits.
static double digits(float value, double shift)
{
    double x = shift * (double)value;
    return x - floor(x);
}

// Correlation of a number with that of the cell (dx, dz) farther on, over the grid.
static double correlation(const float *values, double from, double to, int dx, int dz)
{
    double sum = 0.0;
    int count = 0;
    for (int z = 0; z < SIDE - dz; z++)
        for (int x = 0; x < SIDE - dx; x++, count++)
            sum += (digits(values[4 * (z * SIDE + x)], from) - 0.5) *
                   (digits(values[4 * ((z + dz) * SIDE + x + dx)], to) - 0.5);
    return 12.0 * sum / count; // 1/12 is the variance of an even distribution
}

// chi^2 of 64 classes: 63 on average, with a deviation of 11.2; five of them are allowed.
static double chi_square(const float *values, double shift)
{
    int classes[64] = {0};
    double sum = 0.0;
    for (int i = 0; i < SIDE * SIDE; i++)
        classes[(int)(64.0 * digits(values[4 * i], shift))]++;
    for (int k = 0; k < 64; k++)
        sum += (classes[k] - SIDE * SIDE / 64.0) * (classes[k] - SIDE * SIDE / 64.0);
    return sum / (SIDE * SIDE / 64.0);
}

// The largest correlation between the parts of neighbouring cells' numbers; and of one cell's own,
// less the 1 / 64 or 1 / 4096 that a number and the digits behind its first 6 or 12 bits always
// have.
static double worst_correlation(const float *values)
{
    const double shift[3] = {1.0, 64.0, 4096.0};
    double worst = 0.0;
    for (int k = 0; k < 9; k++) {
        double from = shift[k % 3], to = shift[k / 3];
        for (int d = 1; d < 9; d++)
            worst = fmax(worst, fabs(correlation(values, from, to, d % 3, d / 3)));
        if (from < to)
            worst = fmax(worst, fabs(correlation(values, from, to, 0, 0) - from / to));
    }
    return worst;
}

// Of N = 65,536 pairs without connection the correlation deviates by 1 / sqrt(N) = 0.0039 from 0;
// five of those are allowed.
static void test_hash_looks_like_chance(void **unused)
{
    (void)unused;
    float *values = hashes(0.0f);
    double mean = 0.0, uneven = 0.0, worst = worst_correlation(values);
    for (int i = 0; i < SIDE * SIDE; i++)
        mean += (double)values[4 * i] / (SIDE * SIDE);
    for (double shift = 1.0; shift < 5000.0; shift *= 64.0)
        uneven = fmax(uneven, chi_square(values, shift));
    free(values);
    print_message(
        "# cellRandom, 65,536 cells: mean %.4f, chi^2 of 64 classes at most %.0f, largest "
        "correlation %.4f\n",
        mean, uneven, worst);
    assert_true(fabs(mean - 0.5) < 5.0 * 0.2887 / SIDE);
    assert_true(uneven < 63.0 + 5.0 * 11.2 && worst < 5.0 / SIDE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_operators_agree_with_double),
        cmocka_unit_test(test_limited_operators_agree_with_double),
        cmocka_unit_test(test_mod_is_not_fmod),
        cmocka_unit_test(test_the_reports_formula_misses_the_middle),
        cmocka_unit_test(test_hash_is_the_same_to_the_bit),
        cmocka_unit_test(test_hash_looks_like_chance),
    };
    return cmocka_run_group_tests_name("cells", tests, gpu_setup, gpu_teardown);
}
