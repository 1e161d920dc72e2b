// noise.c - values and gradients of shaders/noise.glsl on the GPU compared with double precision,
// and the Lipschitz constants that its comments state: none is exceeded, and those of value noise
// and gradient noise are reached.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/matrix.h"
#include "lib/noise.h"
#include "lib/random.h"

#define SHADER "tests/shaders/noise.frag"

enum { VALUE, GRADIENT, OCTAVES, BLEND, CORNER, DIRECTION, CONSTANTS };
enum { WIDE = 256, ROWS = 64, ITEMS = WIDE * ROWS, SLOTS = 4, PAIRS = 1000000 };

static const double value_stretch = 15.0 / 8.0;
static const double gradient_stretch = 2.7922884880; // sqrt(499) / 8

// The shader's results for ITEMS items: 4 slots of 4 floats each. The caller frees them.
static float *ask(int function, float a, float b, float c)
{
    return gpu_call(SHADER, WIDE * SLOTS, ROWS, function, (const float[4]){a, b, c});
}

// ---- The GPU compared with double precision ----

static double worst_value, worst_gradient;

static void compare(const float *slot, struct noise truth)
{
    worst_value = fmax(worst_value, fabs((double)slot[0] - truth.value));
    worst_gradient = fmax(worst_gradient, d3_length(d3_sub(d3_of(slot + 1), truth.gradient)));
}

// Coordinates of about 20 have an error of 1e-6, and those of the octaves about four times that.
// The gradients change by at most 15 per cell, and those of the octaves by 8 times as much.
TEST(test_the_gpu_agrees_with_double)
{
    static const char *const names[] = {"value noise", "gradient noise", "four octaves"};
    for (int which = VALUE; which <= OCTAVES; which++) {
        float *values = ask(which, 4.0f, 0.5f, 2.0f);
        worst_value = worst_gradient = 0.0;
        for (int i = 0; i < ITEMS; i++) {
            const float *slot = values + 16 * i;
            struct d3 p = d3_of(slot);
            compare(slot + 4, which == VALUE      ? noise_value(p)
                              : which == GRADIENT ? noise_gradient(p)
                                                  : noise_octaves(p, 4, 0.5, 2.0));
        }
        free(values);
        print_message("# %s, %d points: value off by %.2g, gradient by %.2g\n", names[which], ITEMS,
                      worst_value, worst_gradient);
        assert_true(worst_value < (which == OCTAVES ? 2e-5 : 3e-6));
        assert_true(worst_gradient < (which == OCTAVES ? 3e-4 : 3e-5));
    }
}

TEST(test_the_blend_agrees_with_double)
{
    float *values = ask(BLEND, 0.0f, 0.0f, 0.0f);
    worst_value = worst_gradient = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        const float *slot = values + 16 * i;
        double number[8];
        for (int k = 0; k < 8; k++)
            number[k] = (double)slot[8 + k];
        compare(slot + 4, noise_blend(d3_of(slot), number));
    }
    free(values);
    print_message("# blend: value off by %.2g, gradient by %.2g\n", worst_value, worst_gradient);
    assert_true(worst_value < 3e-6 && worst_gradient < 1e-5);

    values = ask(CORNER, 0.0f, 0.0f, 0.0f);
    worst_value = worst_gradient = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        const float *slot = values + 16 * i;
        struct d3 direction[8] = {{0}};
        int corner = (int)slot[8] + 2 * (int)slot[9] + 4 * (int)slot[10];
        direction[corner] = d3_of(slot + 12);
        compare(slot + 4, noise_slopes(d3_of(slot), direction));
    }
    free(values);
    print_message("# corner: value off by %.2g, gradient by %.2g\n", worst_value, worst_gradient);
    assert_true(worst_value < 1e-6 && worst_gradient < 4e-6);
}

TEST(test_directions_have_length_1)
{
    float *values = ask(DIRECTION, 0.0f, 0.0f, 0.0f);
    struct d3 sum = {0};
    for (int i = 0; i < ITEMS; i++) {
        const float *slot = values + 16 * i;
        uint32_t bits = (uint32_t)slot[4] << 16 | (uint32_t)slot[5];
        struct d3 truth =
            d3_unit(d3(2.0 * (bits & 1023) - 1023.0, 2.0 * (bits >> 10 & 1023) - 1023.0,
                       2.0 * (bits >> 20 & 1023) - 1023.0));
        assert_true(d3_length(d3_sub(d3_of(slot), truth)) < 1e-6);
        sum = d3_add(sum, truth);
    }
    free(values);
    assert_true(d3_length(sum) / ITEMS < 0.02); // no direction is preferred
}

// ---- The gradients are those of the values ----

static struct noise four_octaves(struct d3 p)
{
    return noise_octaves(p, 4, 0.5, 2.0);
}

TEST(test_gradients_are_slopes)
{
    struct noise (*const functions[])(struct d3) = {noise_value, noise_gradient, four_octaves};
    const double h = 1e-5;
    double worst = 0.0;
    srand(1);
    for (int which = 0; which < 3; which++)
        for (int i = 0; i < 2000; i++) {
            struct d3 p = random_point(-9.0, 9.0), n = random_direction();
            double rise = functions[which](d3_add(p, d3_times(h, n))).value -
                          functions[which](d3_sub(p, d3_times(h, n))).value;
            worst = fmax(worst, fabs(rise / (2.0 * h) - d3_dot(n, functions[which](p).gradient)));
        }
    print_message("# gradients differ from finite differences by at most %.2g\n", worst);
    assert_true(worst < 1e-7);
}

// ---- The constants ----

// The largest |f(p) - f(q)| / |p - q| over pairs of points, most of them near each other.
static double stretch_of_pairs(struct noise (*function)(struct d3), int pairs)
{
    double largest = 0.0;
    srand(2);
    for (int i = 0; i < pairs; i++) {
        struct d3 p = random_point(-50.0, 50.0);
        double apart = i % 4 == 0 ? random_in(0.01, 2.0) : 0.01;
        struct d3 q = d3_add(p, d3_times(apart, random_direction()));
        largest = fmax(largest, fabs(function(p).value - function(q).value) / apart);
    }
    return largest;
}

// In a product of probability spaces, the variance of a function is at least that of its
// first-order part. The bound therefore needs only one inequality:
// slope^2 <= 4 (15/8)^2 fade (1 - fade).
TEST(test_the_lemma_of_the_fade_is_true)
{
    double largest = 0.0;
    for (int i = 1; i < 100000; i++) {
        double x = i / 100000.0, u = noise_fade(x), s = noise_slope(x);
        double quotient = s / (2.0 * sqrt(u * (1.0 - u)));
        largest = fmax(largest, quotient);
        assert_true(quotient <= value_stretch * (1.0 + 1e-9));
    }
    assert_true(largest > 0.999999 * value_stretch);
}

// The length of the longest gradient on a grid in the cell, for all sets of eight numbers that are
// 0 or 1. The length is a convex function of the numbers, so no other numbers between 0 and 1 give
// a longer gradient.
static double steepest_blend(int grid)
{
    double largest = 0.0;
    for (int set = 0; set < 256; set++) {
        double number[8];
        for (int k = 0; k < 8; k++)
            number[k] = set >> k & 1;
        for (int i = 0; i <= grid; i++)
            for (int j = 0; j <= grid; j++)
                for (int k = 0; k <= grid; k++) {
                    struct d3 x = d3(1.0 * i / grid, 1.0 * j / grid, 1.0 * k / grid);
                    largest = fmax(largest, d3_length(noise_blend(x, number).gradient));
                }
    }
    return largest;
}

TEST(test_value_noise_has_its_constant)
{
    float *values = ask(CONSTANTS, 1.0f, 0.5f, 2.0f);
    double stated = (double)values[0];
    free(values);
    double pairs = stretch_of_pairs(noise_value, PAIRS), reached = steepest_blend(14);
    print_message("# value noise: stated %.6f; %d pairs at most %.4f; reached %.6f\n", stated,
                  PAIRS, pairs, reached);
    assert_true(fabs(stated - value_stretch) < 1e-6);
    assert_true(pairs <= value_stretch && pairs > 0.5 * value_stretch);
    assert_true(reached <= value_stretch * (1.0 + 1e-12) && reached > 0.99 * value_stretch);
}

// An upper bound on the length of the gradient at x, for any eight directions g. The gradient is
// the sum over the corners of A g with A = weight I + (gradient of the weight) (x - corner)^T. By
// the Cauchy-Schwarz inequality, the square of its length is at most the sum of the numbers
// r = sqrt(weight), times the largest eigenvalue of the sum of A A^T / r.
static double bound_of_slopes(struct d3 x)
{
    double roots = 0.0, m[3][3] = {{0.0}};
    double at[3] = {x.x, x.y, x.z};
    for (int k = 0; k < 8; k++) {
        double share[3], slope[3], g[3], a[3][3], w = 1.0;
        for (int i = 0; i < 3; i++) {
            bool high = (k >> i & 1) != 0;
            share[i] = high ? noise_fade(at[i]) : 1.0 - noise_fade(at[i]);
            slope[i] = high ? noise_slope(at[i]) : -noise_slope(at[i]);
            w *= share[i];
        }
        if (w < 1e-12)
            continue;
        for (int i = 0; i < 3; i++)
            g[i] = slope[i] * share[(i + 1) % 3] * share[(i + 2) % 3];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                a[i][j] = (i == j ? w : 0.0) + g[i] * (at[j] - (k >> j & 1));
        roots += sqrt(w);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                for (int l = 0; l < 3; l++)
                    m[i][j] += a[i][l] * a[j][l] / sqrt(w);
    }
    // The largest stretch of a symmetric matrix without negative eigenvalues is its largest
    // eigenvalue.
    struct m3 matrix = {{d3(m[0][0], m[1][0], m[2][0]), d3(m[0][1], m[1][1], m[2][1]),
                         d3(m[0][2], m[1][2], m[2][2])}};
    return sqrt(roots * m3_largest_stretch(&matrix));
}

// The length of the gradient at the centre of the cell, for the directions that make the slope
// along x steepest.
static double reached_by_slopes(void)
{
    struct d3 direction[8], middle = d3(0.5, 0.5, 0.5);
    for (int k = 0; k < 8; k++) {
        struct d3 away = d3_sub(middle, d3(k & 1, k >> 1 & 1, k >> 2));
        double slope = (k & 1 ? 1.0 : -1.0) * 15.0 / 32.0; // slope of the weight along x
        direction[k] = d3_unit(d3_add(d3(0.125, 0.0, 0.0), d3_times(slope, away)));
    }
    return d3_length(noise_slopes(middle, direction).gradient);
}

TEST(test_gradient_noise_has_its_constant)
{
    enum { GRID = 50 };
    float *values = ask(CONSTANTS, 1.0f, 0.5f, 2.0f);
    double stated = (double)values[1], largest = 0.0;
    struct d3 where = {0};
    free(values);
    for (int i = 0; i <= GRID; i++) // a 48th of the cell; by symmetry, the rest gives the same
        for (int j = 0; j <= i; j++)
            for (int k = 0; k <= j; k++) {
                struct d3 x = d3(0.5 * i / GRID, 0.5 * j / GRID, 0.5 * k / GRID);
                double bound = bound_of_slopes(x);
                where = bound > largest ? x : where;
                largest = fmax(largest, bound);
            }
    double pairs = stretch_of_pairs(noise_gradient, PAIRS), reached = reached_by_slopes();
    print_message(
        "# gradient noise: stated %.6f; bound at most %.6f, at %.2f %.2f %.2f; %d pairs at most "
        "%.4f; reached %.6f\n",
        stated, largest, where.x, where.y, where.z, PAIRS, pairs, reached);
    assert_true(fabs(stated - gradient_stretch) < 1e-6);
    assert_true(largest <= gradient_stretch * (1.0 + 1e-9));
    assert_true(pairs <= gradient_stretch && pairs > 0.5 * gradient_stretch);
    assert_true(reached > 0.99 * gradient_stretch && reached <= gradient_stretch * (1.0 + 1e-9));
}

// The values are within the ranges that the comments of noise.glsl state, and come close to the
// ends of the ranges.
TEST(test_values_stay_in_the_stated_ranges)
{
    double low = 1.0, high = 0.0, most = 0.0;
    srand(3);
    for (int i = 0; i < 200000; i++) {
        struct d3 p = random_point(-90.0, 90.0);
        double v = noise_octaves(p, 4, 0.5, 2.0).value;
        low = fmin(low, v);
        high = fmax(high, v);
        most = fmax(most, fabs(noise_gradient(p).value));
    }
    struct d3 direction[8], middle = d3(0.5, 0.5, 0.5);
    for (int k = 0; k < 8; k++)
        direction[k] = d3_unit(d3_sub(middle, d3(k & 1, k >> 1 & 1, k >> 2)));
    print_message("# four octaves between %.3f and %.3f; gradient noise at most %.3f\n", low, high,
                  most);
    assert_true(low >= 0.0 && low < 0.15 && high < 1.0 && high > 0.85);
    assert_true(most < sqrt(0.75) && most > 0.6);
    assert_true(fabs(noise_slopes(middle, direction).value - sqrt(0.75)) < 1e-12);
}

static double asked_gain;

static struct noise asked_octaves(struct d3 p)
{
    return noise_octaves(p, 4, asked_gain, 2.0);
}

// The stated constant of the octaves is never exceeded. It stays bounded for any number of octaves
// if, and only if, gain x lacunarity < 1.
TEST(test_octaves_have_their_constant)
{
    static const float gains[] = {0.3f, 0.45f, 0.5f, 0.7f};
    for (int i = 0; i < 4; i++) {
        asked_gain = (double)gains[i];
        float *values = ask(CONSTANTS, 4.0f, gains[i], 2.0f);
        double stated = (double)values[2], sum = (double)values[3];
        free(values);
        double pairs = stretch_of_pairs(asked_octaves, PAIRS / 4);
        double many = noise_octave_stretch(120, asked_gain, 2.0),
               more = noise_octave_stretch(240, asked_gain, 2.0);
        print_message("# four octaves, gain %.2f: stated %.4f, %d pairs at most %.4f; 120 octaves "
                      "%.4g, 240 %.4g\n",
                      asked_gain, stated, PAIRS / 4, pairs, many, more);
        assert_true(fabs(stated - noise_octave_stretch(4, asked_gain, 2.0)) < 1e-5);
        assert_true(fabs(sum - noise_sum(asked_gain, 4)) < 1e-6);
        assert_true(pairs <= stated && pairs > 0.35 * stated);
        assert_true((more < many * 1.001) == (2.0 * asked_gain < 0.999));
    }
}

// No two lattice points that are less than 1,565 cells apart have the same bits: the test checks
// all differences (a, b, c). c follows from a and b, because LATTICE_STEP.z is odd.
TEST(test_lattice_points_agree_only_far_away)
{
    const uint32_t x = 0x8da6b343u, y = 0xd8163841u, z = 0xcb1ab31fu;
    uint32_t inverse = z;
    for (int i = 0; i < 5; i++)
        inverse *= 2 - z * inverse;
    assert_true(inverse * z == 1);
    double nearest = 1e9;
    for (int a = 0; a <= 1600; a++)
        for (int b = a == 0 ? 1 : -1600; b <= 1600; b++) {
            int32_t c = (int32_t)((0u - x * (uint32_t)a - y * (uint32_t)b) * inverse);
            nearest = fmin(nearest, d3_length(d3(a, b, c)));
        }
    print_message("# lattice points with the same bits are at least %.1f apart\n", nearest);
    assert_true(nearest > 1565.0);
    assert_true(noise_bits(1039, -243, 1146) == noise_bits(0, 0, 0));
}

TESTS(gpu_setup, gpu_teardown)
