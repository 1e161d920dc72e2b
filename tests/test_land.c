// test_land.c - shaders/land.glsl and water.glsl against double precision: noise on the plane as a
// slice of noise in space, slopes and the way to close a gap, waves averaged by sums over a pixel,
// the light of glitter all together; and the land of chapter 21 told once more: its bounds against
// the nearest land, searched for.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_gpu.h"
#include "support_noise.h"

#define SHADER "tests/shaders/land.frag"

enum { NOISE, RIDGED, HILL, WAY, WAVES, GLITTER };

static const double pi = 3.14159265358979323846;

// ---- The library ----

static struct noise plane_noise(double x, double z)
{
    return noise_value(d3(x, 0.0, z));
}

static void noise_on_the_plane_is_a_slice_of_noise_in_space(void **unused)
{
    (void)unused;
    const float from[4] = {-3.0f, 5.0f, 0.0f, 0.0f};
    double worst = 0.0;
    float *values = gpu_call(SHADER, 128, 128, NOISE, from);
    float *folded = gpu_call(SHADER, 128, 128, RIDGED, from);
    for (int i = 0; i < 128 * 128; i++) {
        struct noise right = plane_noise(-3.0 + i % 128 / 16.0, 5.0 + (double)(i / 128) / 16.0);
        double side = right.value > 0.5 ? -2.0 : 2.0;
        worst = fmax(worst, fabs((double)values[4 * i] - right.value));
        worst = fmax(worst, fabs((double)values[4 * i + 1] - right.gradient.x));
        worst = fmax(worst, fabs((double)values[4 * i + 2] - right.gradient.z));
        worst = fmax(worst, fabs((double)folded[4 * i] - (1.0 - fabs(2.0 * right.value - 1.0))));
        if (fabs(right.value - 0.5) > 1e-5)
            worst = fmax(worst, fabs((double)folded[4 * i + 1] - side * right.gradient.x));
    }
    free(values);
    free(folded);
    print_message("# noise on the plane: worst %.2g\n", worst);
    assert_true(worst < 1e-5);
}

static double bump(double x, double z, double a, double b, double height)
{
    double w = fmax(1.0 - x * x / (a * a) - z * z / (b * b), 0.0);
    return height * w * w;
}

static void a_hill_is_no_steeper_than_is_said(void **unused)
{
    (void)unused;
    const float numbers[4] = {3.0f, 2.0f, 1.5f, 0.0f};
    float *values = gpu_call(SHADER, 128, 128, HILL, numbers);
    double steepest = 0.0, worst = 0.0;
    for (int i = 0; i < 128 * 128; i++) {
        double x = i % 128 / 16.0 - 4.0, z = (double)(i / 128) / 16.0 - 4.0, h = 1e-5;
        double gx = (bump(x + h, z, 3.0, 2.0, 1.5) - bump(x - h, z, 3.0, 2.0, 1.5)) / (2.0 * h);
        double gz = (bump(x, z + h, 3.0, 2.0, 1.5) - bump(x, z - h, 3.0, 2.0, 1.5)) / (2.0 * h);
        worst = fmax(worst, fabs((double)values[4 * i] - bump(x, z, 3.0, 2.0, 1.5)));
        worst = fmax(worst, hypot((double)values[4 * i + 1] - gx, (double)values[4 * i + 2] - gz));
        steepest = fmax(steepest, hypot(gx, gz));
    }
    free(values);
    double bound = 8.0 * sqrt(3.0) / 9.0 * 1.5 / 2.0;
    print_message("# hill: worst %.2g; steepest %.4f, bound %.4f\n", worst, steepest, bound);
    assert_true(worst < 1e-4 && steepest <= bound && steepest > 0.99 * bound);
}

static void the_gap_closes_where_it_is_said(void **unused)
{
    (void)unused;
    double worst = 0.0;
    for (int k = 0; k < 3; k++) {
        const float growth[4] = {k == 0 ? 0.0f : k == 1 ? 0.3f : 5.0f, 0.0f, 0.0f, 0.0f};
        float *values = gpu_call(SHADER, 64, 16, WAY, growth);
        for (int i = 0; i < 64 * 16; i++) {
            double way = (double)values[4 * i + 2];
            double closed = (double)values[4 * i + 1] * way + 0.5 * (double)growth[0] * way * way;
            worst = fmax(worst, fabs(closed / (double)values[4 * i] - 1.0));
        }
        free(values);
    }
    print_message("# way to close a gap: worst relative error %.2g\n", worst);
    assert_true(worst < 2e-6);
}

// ---- Waves ----

static const double wave_x[4] = {1.0, -2.0, 3.0, 0.5}, wave_z[4] = {0.5, 1.5, -1.0, 2.0},
                    steep[4] = {0.1, 0.2, 0.05, 0.15};

// The slope of the four waves along x.
static double wave_slope(double x, double z)
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += steep[i] * wave_x[i] / hypot(wave_x[i], wave_z[i]) *
               cos(wave_x[i] * x + wave_z[i] * z + i);
    return sum;
}

static void a_pixel_sees_the_mean_of_its_waves(void **unused)
{
    (void)unused;
    // The pixel's Gaussian as a sum over 81 x 81 places; its axes have a twelfth of their square as
    // variance.
    const float axes[4] = {1.5f, 0.5f, -0.4f, 1.2f};
    float *values = gpu_call(SHADER, 24, 24, WAVES, axes);
    double worst = 0.0;
    for (int i = 0; i < 24 * 24; i += 7) {
        double mean = 0.0, weights = 0.0;
        for (int k = 0; k < 81 * 81; k++) {
            double a = (k % 81 - 40) / 8.0, b = (double)(k / 81 - 40) / 8.0;
            double weight = exp(-0.5 * (a * a + b * b)), s = 1.0 / sqrt(12.0);
            mean += weight * wave_slope(i % 24 / 8.0 + s * (1.5 * a - 0.4 * b),
                                        (double)(i / 24) / 8.0 + s * (0.5 * a + 1.2 * b));
            weights += weight;
        }
        worst = fmax(worst, fabs((double)values[4 * i] - mean / weights));
    }
    // What the mean has lost, and what is left, are together the variance of all places.
    double all = 0.0, left = 0.0;
    for (int i = 0; i < 4; i++) {
        double a = wave_x[i] * 1.5 + wave_z[i] * 0.5, b = -wave_x[i] * 0.4 + wave_z[i] * 1.2;
        all += 0.25 * steep[i] * steep[i];
        left += 0.25 * steep[i] * steep[i] * exp(-(a * a + b * b) / 12.0);
    }
    print_message("# waves: mean worst %.2g; variance lost %.6f, all %.6f\n", worst,
                  (double)values[2], all);
    assert_true(worst < 2e-6 && fabs((double)values[2] + left - all) < 1e-6);
    free(values);
}

static void glitter_neither_makes_nor_loses_light(void **unused)
{
    (void)unused;
    // Over all directions of the upper half the light times the cosine adds up to pi times the
    // light's own on the level.
    for (int k = 0; k < 2; k++) {
        const float numbers[4] = {k == 0 ? 0.8f : 0.5f, 1.0f, 0.004f, 0.0f};
        float *values = gpu_call(SHADER, 256, 256, GLITTER, numbers);
        double sum = 0.0;
        for (int i = 0; i < 256 * 256; i++)
            sum += (double)values[4 * i] * (double)values[4 * i + 3];
        sum *= 2.0 * pi / (256.0 * 256.0);
        free(values);
        double right = pi * (double)numbers[0];
        print_message("# glitter at %.1f: %.4f of %.4f\n", (double)numbers[0], sum, right);
        assert_true(fabs(sum / right - 1.0) < 0.02);
    }
}

// ---- The land of chapter 21 ----

static const double cells = 0.08, gain = 0.42, lacunarity = 2.1, foot = 0.4, ridges = 3.6,
                    hill_slope = 0.45;
enum { OCTAVES = 4 };

static double hills(double x, double z)
{
    double h = bump(x - 4.0, z - 46.0, 43.0, 25.5, 7.4);
    h = fmax(h, bump(x + 25.0, z - 24.0, 24.0, 24.5, 7.0));
    h = fmax(h, bump(x - 64.0, z - 90.0, 58.0, 42.0, 6.4));
    h = fmax(h, bump(x - 19.0, z - 22.0, 13.0, 12.5, 3.6));
    return h - 3.0;
}

static double shore(double x, double z)
{
    double a = x + 1.45, b = 1.2 * (z - 0.5);
    return 0.26 - 0.17 * sqrt(a * a + b * b + 0.04);
}

// The sums over the first octaves, and with the rest of the weights.
static void detail(double x, double z, int count, double *least, double *most)
{
    double u = cells * x + 31.2, v = cells * z + 9.9, weight = 1.0 - gain, sum = 0.0, rest = 1.0;
    double first = 1.0;
    for (int i = 0; i < count; i++) {
        double ridge = 1.0 - fabs(2.0 * plane_noise(u, v).value - 1.0);
        first = i == 0 ? ridge : first;
        sum += weight * ridge;
        rest -= weight;
        weight *= gain;
        double next = lacunarity * (0.8 * u - 0.6 * v) + 17.17;
        v = lacunarity * (0.6 * u + 0.8 * v) + 29.73;
        u = next;
    }
    *least = first * sum;
    *most = first * (sum + (count < OCTAVES ? rest : 0.0));
}

static double land(double x, double z)
{
    double base = hills(x, z), least, most;
    detail(x, z, OCTAVES, &least, &most);
    return fmax(base + ridges * fmax(base - foot, 0.0) * most, shore(x, z));
}

// The largest of all bounds, for all directions.
static double land_distance(struct d3 p)
{
    double base = hills(p.x, p.z), high = ridges * fmax(base - foot, 0.0);
    double under = fmin(p.y, foot + (p.y - foot) / (1.0 + ridges));
    double d = (under - base) / (0.65 + hill_slope), slope = 0.0, weight = 1.0 - gain;
    for (int i = 0; i < OCTAVES; i++) {
        double least, most;
        detail(p.x, p.z, i + 1, &least, &most);
        slope += (i == 0 ? 1.0 + weight : weight) * 3.75 * cells * pow(lacunarity, i);
        weight *= gain;
        double s = 0.65 + hill_slope + ridges * hill_slope * most + high * slope;
        double g = 2.0 * ridges * hill_slope * slope, gap = p.y - base - high * most;
        d = fmax(d, 2.0 * gap / (s + sqrt(fmax(s * s + 2.0 * g * gap, 1e-9))));
    }
    return fmin(d, (p.y - shore(p.x, p.z)) / 1.03);
}

static double random_in(double from, double to)
{
    return from + (to - from) * rand() / RAND_MAX;
}

// A place over the land, up to three units above it.
static struct d3 random_place(void)
{
    double x = rand() % 4 ? random_in(-40.0, 40.0) : random_in(-4.0, 2.0);
    double z = rand() % 4 ? random_in(0.0, 80.0) : random_in(-2.0, 3.0);
    return d3(x, fmax(land(x, z), 0.0) + random_in(0.0, 3.0), z);
}

static void the_largest_bound_is_1_lipschitz(void **unused)
{
    (void)unused;
    enum { PAIRS = 100000 };
    double most = 0.0, slopes = 0.0;
    srand(21);
    for (int i = 0; i < PAIRS; i++) {
        struct d3 p = random_place(), v;
        do {
            double a = random_in(-1.0, 1.0), b = random_in(-1.0, 1.0);
            v = d3(a, b, random_in(-1.0, 1.0));
        } while (d3_length(v) > 1.0 || d3_length(v) < 0.01);
        v = d3_unit(v);
        struct d3 q = d3_add(p, d3_times(1e-3, v));
        most = fmax(most, fabs(land_distance(p) - land_distance(q)) / 1e-3);
        double level = hypot(v.x, v.z);
        slopes = fmax(slopes, fabs(land(p.x, p.z) - land(q.x, q.z)) / (1e-3 * level));
    }
    print_message(
        "# %d pairs: the distance changes by at most %.4f of the way; the land is no steeper "
        "than %.2f, where the bound at the top is 14.8\n",
        PAIRS, most, slopes);
    assert_true(most <= 1.0 + 1e-6 && slopes < 14.8);
}

static void no_land_is_nearer_than_the_distance(void **unused)
{
    (void)unused;
    enum { PLACES = 300, AROUND = 48, STEPS = 40 };
    double nearest = 1e9;
    srand(22);
    for (int i = 0; i < PLACES; i++) {
        struct d3 p = random_place();
        double d = land_distance(p);
        for (int k = 0; d > 0.0 && k < AROUND * STEPS; k++) {
            double turn = 2.0 * pi * (k % AROUND) / AROUND, far = d * (k / AROUND + 1) / STEPS;
            double height = land(p.x + far * cos(turn), p.z + far * sin(turn));
            double low = p.y - sqrt(fmax(d * d - far * far, 0.0)); // of the ball over that place
            nearest = fmin(nearest, low - height);
        }
    }
    print_message(
        "# %d balls of the distance: the land stays below each of them by at least %.2g\n", PLACES,
        nearest);
    assert_true(nearest > -1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_on_the_plane_is_a_slice_of_noise_in_space),
        cmocka_unit_test(a_hill_is_no_steeper_than_is_said),
        cmocka_unit_test(the_gap_closes_where_it_is_said),
        cmocka_unit_test(a_pixel_sees_the_mean_of_its_waves),
        cmocka_unit_test(glitter_neither_makes_nor_loses_light),
        cmocka_unit_test(the_largest_bound_is_1_lipschitz),
        cmocka_unit_test(no_land_is_nearer_than_the_distance),
    };
    return cmocka_run_group_tests_name("land", tests, gpu_setup, gpu_teardown);
}
