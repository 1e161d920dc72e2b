// test_repetition.c - repeated volumes as the GPU computes them, against brute force over all
// copies in double precision; the cell's hash against its definition, and as chance.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_gpu.h"
#include "support_mirror.h"

#define SHADER "tests/shaders/repetition.frag"

enum { WIDE = 256, ROWS = 64, ITEMS = WIDE * ROWS, SIDE = 256 };

// What the shader's Time chooses.
enum {
    SYMMETRIC,
    LIMITED,
    MIRRORED,
    PLANK_OWN,
    PLANK_BOTH,
    PLANK_LIMITED,
    PLANK_GHOSTS,
    OFFSET_OWN,
    OFFSET_BOTH,
    TOWERS,
    TOWERS_CAPPED,
    ROW,
    ROW_LIMITED,
    LONELY,
    NUMBERS = 20,
    MORE_NUMBERS,
    LIMITED_NUMBERS,
    HASH
};

static struct gpu gpu;

static int open_gpu(void **unused)
{
    (void)unused;
    return gpu_open(&gpu) && gpu_load(&gpu, SHADER) ? 0 : -1;
}

static int close_gpu(void **unused)
{
    (void)unused;
    gpu_close(&gpu);
    return 0;
}

// ---- One copy ----

static double hash(int x, int y, int z)
{
    uint32_t v[3] = {(uint32_t)x, (uint32_t)y, (uint32_t)z};
    for (int i = 0; i < 3; i++)
        v[i] = v[i] * 1664525u + 1013904223u;
    for (int round = 0; round < 2; round++) {
        uint32_t product[3] = {v[1] * v[2], v[2] * v[0], v[0] * v[1]};
        for (int i = 0; i < 3; i++)
            v[i] += product[i];
        for (int i = 0; i < 3 && round == 0; i++)
            v[i] ^= v[i] >> 16;
    }
    return (double)(v[0] >> 8) / 16777216.0;
}

static double symmetric(struct d3 q)
{
    return fmin(brute_box(q, d3(0.9, 0.3, 0.5)), d3_length(q) - 0.7);
}

static double plank(struct d3 q)
{
    const double c = cos(MIRROR_PI / 6.0), s = 0.5;
    return brute_box(d3(c * q.x - s * q.z, q.y, s * q.x + c * q.z), d3(1.2, 1.0, 0.2));
}

static double offset_ball(struct d3 q)
{
    return d3_length(d3_sub(q, d3(1.5, 0.0, 0.0))) - 0.4;
}

static double tower(struct d3 q, int x, int z)
{
    double tall = 0.25 + 5.75 * hash(x, 0, z);
    return brute_box(d3(q.x, q.y - tall, q.z), d3(0.8, tall, 0.8));
}

// The copy of cell (x, y, z), its middle at the origin.
static double copy(int function, struct d3 q, int x, int z)
{
    if (function <= LIMITED)
        return symmetric(q);
    if (function == MIRRORED)
        return plank(d3(x % 2 == 0 ? q.x : -q.x, q.y, q.z));
    if (function <= PLANK_GHOSTS)
        return plank(q);
    return function <= OFFSET_BOTH ? offset_ball(q) : tower(q, x, z);
}

// ---- All copies ----

struct field {
    int function;
    float v[4]; // period, axes, first, last
};

static int nearest_cell(const struct field *field, int axis, double x)
{
    return (double)field->v[1] > axis ? (int)lround(x / (double)field->v[0]) : 0;
}

// The cells along an axis that are tried: all near x, of those that exist.
static void cells_tried(const struct field *field, int axis, double x, int range[2])
{
    int reach = (double)field->v[1] > axis ? (field->function < TOWERS ? 2 : 7) : 0;
    int middle = nearest_cell(field, axis, x);
    range[0] = middle - reach;
    range[1] = middle + reach;
    if (field->v[3] > field->v[2] && reach > 0) {
        range[0] = (int)field->v[2];
        range[1] = (int)field->v[3];
    }
}

// The distance to the nearest of all copies. Axes are repeated in the order x, z, y.
static double brute(const struct field *field, struct d3 p)
{
    int xs[2], ys[2], zs[2];
    double period = (double)field->v[0], nearest = 1e9;
    cells_tried(field, 0, p.x, xs);
    cells_tried(field, 1, p.z, zs);
    cells_tried(field, 2, p.y, ys);
    for (int x = xs[0]; x <= xs[1]; x++)
        for (int y = ys[0]; y <= ys[1]; y++)
            for (int z = zs[0]; z <= zs[1]; z++)
                nearest =
                    fmin(nearest, copy(field->function,
                                       d3_sub(p, d3(period * x, period * y, period * z)), x, z));
    return nearest;
}

static float *ask(const struct field *field)
{
    float *values = gpu_call(&gpu, WIDE, ROWS, field->function, field->v);
    assert_non_null(values);
    return values;
}

// What was found over all points: how far the GPU's number lies over and under the brute force.
struct found {
    double over, under; // largest, >= 0
    int outside;        // points outside of all copies
};

static struct found compare(const struct field *field)
{
    struct found found = {0.0, 0.0, 0};
    float *values = ask(field);
    for (int i = 0; i < ITEMS; i++) {
        double truth = brute(field, d3_of(values + 4 * i));
        if (truth < 0.0)
            continue;
        double error = (double)values[4 * i + 3] - truth;
        found.over = fmax(found.over, error);
        found.under = fmax(found.under, -error);
        found.outside++;
    }
    free(values);
    assert_true(found.outside > ITEMS / 2);
    return found;
}

static const double rounding = 6e-6; // coordinates to 20, a few roundings of 6e-8 each

static void check_exact(const char *what, const struct field *field)
{
    struct found found = compare(field);
    print_message("# %s: %d points outside, off by at most %.1e\n", what, found.outside,
                  fmax(found.over, found.under));
    assert_true(found.over < rounding && found.under < rounding);
}

static void check_bound(const char *what, const struct field *field)
{
    struct found found = compare(field);
    print_message("# %s: never more than %.1e over, up to %.2f under\n", what, found.over,
                  found.under);
    assert_true(found.over < rounding && found.under > 0.1);
}

// The largest over-estimate, which must be known to 3 per cent.
static void check_over(const char *what, const struct field *field, double expected)
{
    struct found found = compare(field);
    print_message("# %s: over-estimates by up to %.3f\n", what, found.over);
    assert_true(fabs(found.over / expected - 1.0) < 0.03);
}

static void test_symmetric_copies_are_exact_outside(void **unused)
{
    (void)unused;
    check_exact("one axis", &(struct field){SYMMETRIC, {2.5f, 1.0f, 0.0f, 0.0f}});
    check_exact("two axes", &(struct field){SYMMETRIC, {2.5f, 2.0f, 0.0f, 0.0f}});
    check_exact("three axes", &(struct field){SYMMETRIC, {2.5f, 3.0f, 0.0f, 0.0f}});
    check_exact("cells -2 to 1", &(struct field){LIMITED, {2.5f, 2.0f, -2.0f, 1.0f}});
}

static void test_mirrored_copies_need_no_correction(void **unused)
{
    (void)unused;
    check_exact("mirrored planks", &(struct field){MIRRORED, {2.5f, 1.0f, 0.0f, 0.0f}});
}

static void test_the_own_copy_alone_over_estimates(void **unused)
{
    (void)unused;
    check_over("ball 1.5 aside", &(struct field){OFFSET_OWN, {4.0f, 1.0f, 0.0f, 0.0f}}, 3.0);
    check_over("plank", &(struct field){PLANK_OWN, {2.5f, 1.0f, 0.0f, 0.0f}}, 0.94);
}

static void test_the_nearer_neighbour_mends_identical_copies(void **unused)
{
    (void)unused;
    check_exact("ball, both", &(struct field){OFFSET_BOTH, {4.0f, 1.0f, 0.0f, 0.0f}});
    check_exact("plank, both", &(struct field){PLANK_BOTH, {2.5f, 1.0f, 0.0f, 0.0f}});
    check_exact("plank, -2 to 1", &(struct field){PLANK_LIMITED, {2.5f, 1.0f, -2.0f, 1.0f}});
    struct found ghosts = compare(&(struct field){PLANK_GHOSTS, {2.5f, 1.0f, -2.0f, 1.0f}});
    print_message("# neighbours that do not exist: %.2f too little\n", ghosts.under);
    assert_true(ghosts.under > 1.0 && ghosts.over < rounding);
}

static void test_copies_that_vary_need_the_wall(void **unused)
{
    (void)unused;
    check_bound("towers, capped", &(struct field){TOWERS_CAPPED, {2.0f, 2.0f, 0.0f, 0.0f}});
    check_bound("towers -2 to 1", &(struct field){ROW_LIMITED, {2.0f, 1.0f, -2.0f, 1.0f}});
    check_bound("own tower, others", &(struct field){LONELY, {2.0f, 2.0f, 0.0f, 0.0f}});
    struct found four = compare(&(struct field){TOWERS, {2.0f, 2.0f, 0.0f, 0.0f}});
    struct found three = compare(&(struct field){ROW, {2.0f, 1.0f, 0.0f, 0.0f}});
    print_message("# no cap: four towers of a field over by %.2f, three of a row by %.2f\n",
                  four.over, three.over);
    assert_true(four.over > 1.0 && three.over > 1.0);
}

// ---- Numbers ----

struct period_limits {
    float period, reach, first, last;
};

static const struct period_limits all_periods[] = {{2.0f, 0.75f, -3.0f, 5.0f},
                                                   {2.5f, 1.0f, 0.0f, 0.0f},
                                                   {0.75f, 0.25f, -7.0f, -2.0f},
                                                   {5.5f, 0.625f, 4.0f, 9.0f}};

static float *numbers_of(int function, const struct period_limits *limits)
{
    const float v[4] = {limits->period, limits->reach, limits->first, limits->last};
    float *values = gpu_call(&gpu, WIDE, ROWS, function, v);
    assert_non_null(values);
    return values;
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
    const float v[4] = {slice, 0.0f, 0.0f, 0.0f};
    float *values = gpu_call(&gpu, SIDE, SIDE, HASH, v);
    assert_non_null(values);
    return values;
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
            assert_true((double)v[0] == hash(x, y, z) && (double)v[1] == hash(z, x, y));
            assert_true((double)v[2] == hash(y, z, x));
            assert_true((double)v[3] == hash(8191 * x, 8191 * y, 8191 * z));
        }
        free(values);
    }
    assert_true(hash(0, 0, 0) >= 0.0 && hash(1, 2, 3) < 1.0);
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

// ---- The march ----

// The towers' distance as the library forms it, in double.
static double block(struct d3 p, bool capped)
{
    int x = (int)floor(p.x / 2.0 + 0.5), z = (int)floor(p.z / 2.0 + 0.5);
    double lx = p.x - 2.0 * x, lz = p.z - 2.0 * z,
           nearest = capped ? 1.0 + fmin(fabs(lx), fabs(lz)) : 1e9;
    int sx = lx < 0.0 ? -1 : 1, sz = lz < 0.0 ? -1 : 1;
    for (int i = 0; i < 4; i++) {
        int dx = i % 2 == 0 ? 0 : sx, dz = i / 2 == 0 ? 0 : sz;
        nearest = fmin(nearest, tower(d3(lx - 2.0 * dx, p.y, lz - 2.0 * dz), x + dx, z + dz));
    }
    return nearest;
}

static double march(struct d3 origin, struct d3 direction, bool capped)
{
    double t = 0.0;
    for (int step = 0; step < 2000 && t < 24.0; step++) {
        double distance = block(d3_add(origin, d3_times(t, direction)), capped);
        if (distance < 1e-4)
            return t;
        t += distance;
    }
    return 24.0;
}

// Rays from over the towers. The truth: the same march by the brute force over all towers.
static double march_brute(struct d3 origin, struct d3 direction)
{
    const struct field field = {TOWERS, {2.0f, 2.0f, 0.0f, 0.0f}};
    double t = 0.0;
    for (int step = 0; step < 2000 && t < 24.0; step++) {
        double distance = brute(&field, d3_add(origin, d3_times(t, direction)));
        if (distance < 1e-4)
            return t;
        t += distance;
    }
    return 24.0;
}

static void test_the_capped_march_misses_nothing(void **unused)
{
    (void)unused;
    int hits = 0, capped_missed = 0, free_missed = 0;
    for (int i = 0; i < 1500; i++) {
        struct d3 origin = d3(40.0 * hash(i, 1, 0) - 20.0, 12.5 + 2.0 * hash(i, 4, 0),
                              40.0 * hash(i, 2, 0) - 20.0);
        double turn = 2.0 * MIRROR_PI * hash(i, 3, 0), fall = 0.2 + 0.6 * hash(i, 5, 0);
        struct d3 direction = d3_unit(d3(cos(turn), -fall, sin(turn)));
        double truth = march_brute(origin, direction);
        hits += truth < 24.0;
        capped_missed += fabs(march(origin, direction, true) - truth) > 0.01;
        free_missed += fabs(march(origin, direction, false) - truth) > 0.01;
    }
    print_message("# of 1500 rays %d hit a tower; capped %d go wrong, without the cap %d\n", hits,
                  capped_missed, free_missed);
    assert_true(hits > 700 && capped_missed == 0 && free_missed > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_symmetric_copies_are_exact_outside),
        cmocka_unit_test(test_mirrored_copies_need_no_correction),
        cmocka_unit_test(test_the_own_copy_alone_over_estimates),
        cmocka_unit_test(test_the_nearer_neighbour_mends_identical_copies),
        cmocka_unit_test(test_copies_that_vary_need_the_wall),
        cmocka_unit_test(test_operators_agree_with_double),
        cmocka_unit_test(test_limited_operators_agree_with_double),
        cmocka_unit_test(test_mod_is_not_fmod),
        cmocka_unit_test(test_the_reports_formula_misses_the_middle),
        cmocka_unit_test(test_hash_is_the_same_to_the_bit),
        cmocka_unit_test(test_hash_looks_like_chance),
        cmocka_unit_test(test_the_capped_march_misses_nothing),
    };
    return cmocka_run_group_tests_name("repetition", tests, open_gpu, close_gpu);
}
