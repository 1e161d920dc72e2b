// cells.c - GLSL's mod, the report's formula for repetition, and cellRandom of
// shaders/repetition.glsl, which is compared with its C version to the last bit and tested as a
// source of random numbers.
#include "lib/test.h"
#include "lib/cell.h"
#include "lib/gpu.h"

#define SHADER "tests/shaders/repetition.frag"

enum { WIDE = 256, ROWS = 64, ITEMS = WIDE * ROWS, SIDE = 256 };

// The functions that Time selects in tests/shaders/repetition.frag.
enum { NUMBERS = 20, MORE_NUMBERS, LIMITED_NUMBERS, HASH };

struct period_limits {
    float period, reach, first, last;
};

static float *numbers_of(int function, const struct period_limits *limits)
{
    return gpu_call(SHADER, WIDE, ROWS, function,
                    (const float[4]){limits->period, limits->reach, limits->first, limits->last});
}

// GLSL's mod takes the floor of the quotient and C's fmod truncates it, so for a positive divisor
// the two differ for every negative number that is not a multiple of the divisor.
TEST(test_mod_is_not_fmod)
{
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

// The result of the report's formula is never closer to 0 than half a period.
TEST(test_the_reports_formula_misses_the_middle)
{
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

TEST(test_hash_is_the_same_to_the_bit)
{
    const int slices[] = {0, -1, 77};
    for (int k = 0; k < 3; k++) {
        float *values = hashes((float)slices[k]);
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE - 128, y = slices[k], z = i / SIDE - 128;
            const float *v = values + 4 * i;
            assert_true((double)v[0] == cell_hash(x, y, z) && (double)v[1] == cell_hash(z, x, y));
            assert_true((double)v[2] == cell_hash(y, z, x));
            assert_true((double)v[3] == cell_hash(8191 * x, 8191 * y, 8191 * z));
            // Exchanging the last two indices has no effect.
            assert_true(cell_hash(x, z, y) == (double)v[0]);
        }
        free(values);
    }
    assert_true(cell_hash(0, 0, 0) >= 0.0 && cell_hash(1, 2, 3) < 1.0);
}

// The random number that chapter 07 takes from a hash value: for shift 1 the value itself, for
// shift 64 or 4096 the fraction after its first 6 or 12 bits.
static double digits(float value, double shift)
{
    double x = shift * (double)value;
    return x - floor(x);
}

// The correlation, over the grid, between the random number of a cell, with the shift `from`, and
// that of the cell (dx, dz) away, with the shift `to`.
static double correlation(const float *values, double from, double to, int dx, int dz)
{
    double sum = 0.0;
    int count = 0;
    for (int z = 0; z < SIDE - dz; z++)
        for (int x = 0; x < SIDE - dx; x++, count++)
            sum += (digits(values[4 * (z * SIDE + x)], from) - 0.5) *
                   (digits(values[4 * ((z + dz) * SIDE + x + dx)], to) - 0.5);
    return 12.0 * sum / count; // 1/12 is the variance of a uniform distribution
}

// The chi^2 of 64 classes is 63 on average, with a standard deviation of 11.2. The test allows five
// standard deviations.
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

// The largest correlation between a number of one cell and a number of a cell up to two away, or
// between two numbers of one cell. A number has a correlation of 1 / 64 or 1 / 4096 with its
// fraction after the first 6 or 12 bits; for two numbers of one cell, this value is subtracted.
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

// The correlation of N = 65,536 independent pairs has a standard deviation of 1 / sqrt(N) = 0.0039;
// five standard deviations are allowed.
TEST(test_hash_looks_random)
{
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

TESTS(gpu_setup, gpu_teardown)
