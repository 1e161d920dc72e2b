// fog.c - shaders/fog.glsl compared with double precision: with sums over thin slices, and with the
// equation of light in fog solved step by step.
#include "lib/test.h"
#include "lib/gpu.h"

#define SHADER "tests/shaders/fog.frag"

enum { DECAY, DEPTH, SKY, INVERSE, LIGHT, HORIZON, LAMP, BEAM };

// Air whose density falls with the height. Below are the density along a ray, and the integral of
// this density, computed with Simpson's rule over count slices.
struct air {
    double height, density, scale;
};

static double density_at(struct air air, double climb, double t)
{
    return air.density * exp(-(air.height + climb * t) / air.scale);
}

static double slices(struct air air, double climb, double t, int count)
{
    double sum = 0.0, step = t / count;
    for (int i = 0; i < count; i++) {
        double a = i * step, b = a + step;
        sum += (density_at(air, climb, a) + 4.0 * density_at(air, climb, 0.5 * (a + b)) +
                density_at(air, climb, b)) *
               step / 6.0;
    }
    return sum;
}

static struct air air_of(const float numbers[4])
{
    return (struct air){(double)numbers[0], (double)numbers[1], (double)numbers[2]};
}

TEST(the_mean_of_a_decay_keeps_its_digits_near_0)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 520, 1, DECAY, none);
    double worst = 0.0;
    for (int i = 0; i < 520; i++) {
        double x = (double)values[4 * i], right = x > 0.0 ? -expm1(-x) / x : 1.0;
        worst = fmax(worst, fabs((double)values[4 * i + 1] / right - 1.0));
    }
    assert_true(values[1] == 1.0f);
    free(values);
    print_message("# mean of the decay: worst relative error %.2g\n", worst);
    assert_true(worst < 1e-6);
}

// Uniform fog and layers of mist, seen from above and from inside. The shader's rays are
// horizontal, climb or descend.
static const float airs[][4] = {{1.6f, 0.05f, 1.5f},
                                {0.0f, 0.2f, 0.4f},
                                {1.6f, 0.05f, 1e6f},
                                {-0.3f, 1.0f, 7.0f},
                                {9.0f, 0.3f, 1.0f}};

enum { AIRS = sizeof airs / sizeof *airs };

TEST(the_depth_is_the_sum_of_thin_slices)
{
    double worst = 0.0;
    for (int k = 0; k < AIRS; k++) {
        float *values = gpu_call(SHADER, 64, 16, DEPTH, airs[k]);
        for (int i = 0; i < 64 * 16; i++) {
            const float *v = values + 4 * i;
            double climb = (double)v[0], t = (double)v[1];
            if (fabs(climb) * t / (double)airs[k][2] > 20.0)
                continue; // along this ray the density changes by a factor of more than e^20
            double right = slices(air_of(airs[k]), climb, t, 2000);
            worst = fmax(worst, fabs((double)v[2] / right - 1.0));
        }
        free(values);
    }
    print_message("# optical depth: worst relative error %.2g\n", worst);
    assert_true(worst < 1e-5);
}

// The ray descends from a height of 200 scales, where the density is 0 as a float, to a height
// where it is not. Computed from the upper end, the depth would be 0 times infinity. The height of
// the lower end is a difference of numbers near 200, so its rounding error is about 200 times that
// of a number near 1.
TEST(a_path_from_far_above_has_a_depth)
{
    const float numbers[4] = {200.0f, 0.5f, 1.0f};
    float *values = gpu_call(SHADER, 32, 26, DEPTH, numbers);
    int reached = 0;
    for (int i = 0; i < 32 * 26; i++) {
        const float *v = values + 4 * i;
        double climb = (double)v[0], low = 200.0 + climb * (double)v[1];
        assert_true(isfinite(v[2]) && v[2] >= 0.0f);
        if (low > 80.0)
            continue; // the depth is almost too small for a float
        double right = 0.5 * (exp(-low) - exp(-200.0)) / -climb;
        assert_true(fabs((double)v[2] / right - 1.0) < 1e-4);
        reached++;
    }
    free(values);
    assert_true(reached > 1);
}

// The right value is the sum along a ray that climbs by 40 scales and so leaves the fog.
TEST(the_sky_is_seen_through_a_finite_fog)
{
    for (int k = 0; k < AIRS; k++) {
        if ((double)airs[k][2] > 100.0)
            continue; // uniform fog hides the sky
        float *values = gpu_call(SHADER, 40, 1, SKY, airs[k]);
        for (int i = 0; i < 40; i++) {
            double climb = (double)values[4 * i], far = 40.0 * (double)airs[k][2] / climb;
            double right = slices(air_of(airs[k]), climb, far, 20000);
            assert_true(fabs((double)values[4 * i + 1] / right - 1.0) < 1e-5);
        }
        free(values);
    }
}

TEST(a_point_has_the_depth_that_was_asked_for)
{
    double worst = 0.0;
    for (int k = 0; k < AIRS - 1; k++) {
        float *values = gpu_call(SHADER, 64, 32, INVERSE, airs[k]);
        for (int i = 0; i < 64 * 32; i++) {
            const float *v = values + 4 * i;
            double whole = slices(air_of(airs[k]), (double)v[0], 6.0, 400);
            double reached = slices(air_of(airs[k]), (double)v[0], (double)v[2], 400);
            worst = fmax(worst, fabs(reached - (double)v[1]) / whole);
        }
        free(values);
    }
    print_message("# point at a given depth: worst error %.2g of the whole depth\n", worst);
    assert_true(worst < 1e-5);
}

// The test solves dL/dt = density (fog - L) with the midpoint rule.
TEST(light_in_fog_obeys_its_equation)
{
    const float numbers[4] = {2.0f, 0.7f, 0.3f};
    float *values = gpu_call(SHADER, 200, 1, LIGHT, numbers);
    double light = 2.0, density = 0.3 * exp(-0.15), step = 0.05 / 50.0, worst = 0.0;
    for (int i = 0; i < 200; i++) {
        worst = fmax(worst, fabs((double)values[4 * i + 1] - light));
        for (int j = 0; j < 50; j++) {
            double half = light + 0.5 * step * density * (0.7 - light);
            light += step * density * (0.7 - half);
        }
    }
    free(values);
    print_message("# light in fog: worst error %.2g\n", worst);
    assert_true(worst < 2e-6);
}

// Near the horizon, the sky above and the ground below both disappear in the fog's own light.
TEST(the_horizon_is_the_fog)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 1000, 1, HORIZON, none);
    for (int i = 0; i < 1000; i++) {
        const float *v = values + 4 * i;
        double climb = (double)v[0];
        double above = 0.02 * exp(-1.6 / 3.0) * 3.0 / climb;
        double below = 0.02 * 3.0 * -expm1(-1.6 / 3.0) / climb;
        assert_true(fabs((double)v[1] - (0.75 + 8.25 * exp(-above))) < 1e-4);
        assert_true(fabs((double)v[2] - 0.75 * -expm1(-below)) < 1e-4);
        assert_true(fabs((double)v[3] - 0.75) < 1e-6);
    }
    assert_true(fabs((double)values[1] - (double)values[2]) < 1e-6);
    free(values);
}

// The test adds up thin slices of 1 / distance^2, with the lamp 0.05 farther from the ray than it
// really is.
TEST(the_light_around_a_lamp_is_the_sum_of_thin_slices)
{
    static const float rays[][4] = {
        {0.0f, 0.3f, -4.0f, 3.0f}, {0.0f, 0.3f, -4.0f, 4.2f}, {2.0f, -1.0f, 3.0f, 1000.0f}};
    double worst = 0.0;
    for (int k = 0; k < 3; k++) {
        float *values = gpu_call(SHADER, 63, 1, LAMP, rays[k]);
        double x = (double)rays[k][0], y = (double)rays[k][1], z = (double)rays[k][2];
        for (int i = 0; i < 63; i++) {
            const float *v = values + 4 * i;
            double a = (double)v[0], b = (double)v[1], c = (double)v[2];
            double nearest = -(x * a + y * b + z * c);
            double aside = sqrt(fmax(x * x + y * y + z * z - nearest * nearest, 0.0)) + 0.05;
            // With t - nearest = aside sinh s, the slices are thin where the lamp is close.
            double from = asinh(-nearest / aside),
                   to = asinh(((double)rays[k][3] - nearest) / aside);
            double sum = 0.0, step = (to - from) / 4000.0;
            for (int j = 0; j < 4000; j++)
                sum += step / (aside * cosh(from + (j + 0.5) * step));
            worst = fmax(worst, fabs((double)v[3] / sum - 1.0));
        }
        free(values);
    }
    print_message("# light around a lamp: worst relative error %.2g\n", worst);
    assert_true(worst < 2e-4);
}

// Where a ray crosses a beam at right angles, 5 units from the eye, the beam's light follows a bell
// curve across the beam, divided by the beam's width, and fog removes light on the way from the
// lamp and to the eye. The light is zero if the ray ends before the beam.
TEST(a_beam_is_as_wide_as_it_says)
{
    const float far[4] = {9.0f, 0.05f}, near[4] = {4.4f, 0.05f};
    float *values = gpu_call(SHADER, 40, 13, BEAM, far),
          *before = gpu_call(SHADER, 40, 13, BEAM, near);
    for (int i = 0; i < 40 * 13; i++) {
        double width = (double)values[4 * i], off = (double)values[4 * i + 1];
        double left = exp(-0.05 * (1.0 + i % 40 + 5.0));
        assert_true(fabs((double)values[4 * i + 2] - exp(-off * off) / width * left) < 1e-3);
        assert_true(before[4 * i + 2] == 0.0f);
    }
    free(values);
    free(before);
}

TESTS(gpu_setup, gpu_teardown)
