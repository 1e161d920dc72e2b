// measure.c - the numbers that the pages quote and build/tests/measure prints, compared with
// theory.
#include "lib/test.h"
#include "lib/bound.h"
#include "lib/measure.h"

static void assert_near(double got, double expected, double share)
{
    if (!(fabs(got - expected) <= share * fabs(expected)))
        fail_msg("%g instead of %g (allowed difference: %g %%)", got, expected, 100.0 * share);
}

// The numbers are worst cases over a set of points, so a few more points change them by a few per
// cent.
TEST(test_normal_error_has_two_sides)
{
    assert_near(measure_normal(0.01).central, 0.0017, 0.1);
    assert_near(measure_normal(0.001).central, 0.017, 0.1);
    assert_near(measure_normal(0.001).forward, 0.055, 0.1);
    assert_near(measure_normal(1e-5).forward, 2.2, 0.1);
    for (double h = 1e-5; h < 0.5; h *= 2.0) {
        struct normal_error e = measure_normal(h);
        assert_true(e.central <= 1.05 * (e.central_truncation + e.rounding));
        assert_true(e.forward <= 1.05 * (e.forward_truncation + e.rounding));
    }
    // Where the truncation error dominates, the measured error agrees with Taylor's series.
    assert_near(measure_normal(0.1).central, measure_normal(0.1).central_truncation, 0.02);
    assert_near(measure_normal(0.1).forward, measure_normal(0.1).forward_truncation, 0.02);
}

// ---- The two curves that the GPU draws about itself ----

enum { CURVE_POINTS = 512, CURVES = 2 }; // curves: central and forward differences

// The central and the forward differences at the point n of the unit ball, in double precision.
static void differences_at(struct d3 n, double step, double difference[CURVES][3])
{
    for (int axis = 0; axis < 3; axis++) {
        struct d3 e = d3(step * (axis == 0), step * (axis == 1), step * (axis == 2));
        double after = d3_length(d3_add(n, e)) - 1.0, before = d3_length(d3_sub(n, e)) - 1.0;
        difference[0][axis] = after - before;
        difference[1][axis] = after;
    }
}

// The root mean square of the truncation errors, in degrees, at the points at which the experiment
// 01_normal_error.frag measures the errors.
static void truncation(double h, double error[CURVES])
{
    double squares[CURVES] = {0.0, 0.0};
    for (int i = 0; i < CURVE_POINTS; i++) {
        double z = 1.0 - (2.0 * i + 1.0) / CURVE_POINTS, turn = 2.39996323 * i;
        double r = sqrt(1.0 - z * z), difference[CURVES][3];
        struct d3 n = d3(r * cos(turn), r * sin(turn), z);
        differences_at(n, h * (1.0 + 0.1 * fmod(0.618034 * i, 1.0)), difference);
        for (int k = 0; k < CURVES; k++) {
            const double *d = difference[k];
            struct d3 apart = d3_sub(d3_unit(d3(d[0], d[1], d[2])), n);
            squares[k] += d3_dot(apart, apart);
        }
    }
    for (int k = 0; k < CURVES; k++)
        error[k] = sqrt(squares[k] / CURVE_POINTS) * 180.0 / MIRROR_PI;
}

// The angle, in degrees, that a curve shows in a column of the 640x360 picture. It is computed from
// the mean height of the pixels that are yellow (central) or blue (forward).
static double drawn_angle(const float *pixel, int column, int curve)
{
    double sum = 0.0, weight = 0.0;
    for (int y = 0; y < 360; y++) {
        const float *colour = pixel + 4 * (y * 640 + column);
        double yellow = (double)colour[0] - (double)colour[2];
        // The background and its lines are bluish.
        double shown = curve == 0 ? yellow : -yellow - 0.1;
        sum += shown > 0.0 ? shown * (y + 0.5) : 0.0;
        weight += shown > 0.0 ? shown : 0.0;
    }
    return pow(10.0, 6.0 * sum / weight / 360.0 - 4.0);
}

// The truncation error is known. The rounding error is a constant divided by h. Most of the
// constant comes from a coordinate near 10, which is rounded to a multiple of 2^-20; the driver's
// square root adds the rest. If a compiler subtracts the 10 first, only the rounding error of a
// length near 1 remains, and the constant can be as small as a sixteenth of its usual value.
TEST(test_drawn_normal_error_is_truncation_and_rounding)
{
    const double rounding[CURVES] = {5.7e-6, 6.7e-6}; // degrees times h
    assert_true(gpu_load("chapters/experiments/01_normal_error.frag"));
    struct renderer_inputs inputs = gpu_inputs(640, 360, 1);
    float *pixel = gpu_numbers(&inputs);
    for (int column = 0; column < 640; column += 8) {
        double h = pow(10.0, 5.0 * (column + 0.5) / 640.0 - 5.0), error[CURVES];
        truncation(h, error);
        for (int k = 0; k < CURVES; k++) {
            double drawn = drawn_angle(pixel, column, k);
            if (!(drawn >= 0.99 * hypot(error[k], rounding[k] / h / 16.0) &&
                  drawn <= 1.01 * hypot(error[k], rounding[k] / h * 1.5)))
                fail_msg("curve %d at h = %g: %g degrees, with a truncation error of %g", k, h,
                         drawn, error[k]);
        }
    }
    free(pixel);
}

TEST(test_steps_to_a_plane_follow_the_formula)
{
    for (double angle = 0.7; angle <= 90.0; angle += 1.3) {
        int answer[2], moves = measure_plane_formula(angle, 0.001);
        assert_int_equal(measure_plane_moves(angle, 0.001), moves);
        bound_ask(sin(angle * MIRROR_PI / 180.0), 0.0, 100.0, 0.001, answer);
        // The library counts one more; rounding may change its count by one.
        assert_true(answer[0] >= moves && answer[0] <= moves + 2);
    }
    assert_int_equal(measure_plane_moves(90.0, 0.001), 1);
    assert_near(measure_plane_limit(60, 0.01), 4.3, 0.01);
    // A march takes one more evaluation than it makes moves. Just above the limiting angle, the
    // evaluations are enough; just below it, they are not.
    for (int evaluations = 60; evaluations <= 256; evaluations *= 2) {
        double limit = measure_plane_limit(evaluations, 0.001);
        assert_true(measure_plane_moves(1.001 * limit, 0.001) + 1 <= evaluations);
        assert_true(measure_plane_moves(0.999 * limit, 0.001) + 1 > evaluations);
    }
}

TEST(test_steps_past_a_ball_follow_the_formula)
{
    int answer[2];
    assert_int_equal(measure_ball_moves(1e-2, 1e-3), 45);
    bound_ask(0.0, 1e-2, 6.0, 1e-3, answer);
    assert_int_equal(answer[0], 45);
    bound_ask(0.0, 1e-3, 6.0, 1e-4, answer);
    assert_true(answer[0] >= 140 && answer[0] <= 142);
    assert_int_equal(measure_ball_moves(1e-3, 1e-4), 141);
    assert_int_equal(measure_ball_moves(1e-4, 1e-5), 445);
    for (double threshold = 1e-3; threshold > 1e-6; threshold /= 10.0)
        assert_near(measure_ball_moves(0.0, threshold), sqrt(2.0 / threshold), 0.1);
}

// A shader in which the library's march meets a ball of radius 1 at an angle.
static const char ball[] = "#include \"main.glsl\"\n"
                           "#include \"march.glsl\"\n"
                           "#include \"primitives.glsl\"\n"
                           "uniform float aside; // 0 in [0, 1]: how far beside the middle\n"
                           "Ray pixelRay(vec2 screen)\n"
                           "{\n"
                           "    return Ray(vec3(-3.0, aside, 0.0), vec3(1.0, 0.0, 0.0));\n"
                           "}\n"
                           "float sceneDistance(vec3 p) { return sdSphere(p, 1.0); }\n"
                           "vec3 rayColour(Ray ray)\n"
                           "{\n"
                           "    return vec3(march(ray, 0.0, 9.0, 0.00001, 1000).t);\n"
                           "}\n";

static double rate_of_library(double cosine)
{
    static struct probe probe; // too large for the stack
    struct renderer_inputs inputs = {.width = 4, .height = 4, .samples = 1};
    char setting[64];
    double hit = 3.0 - cosine, rate = 0.0;
    snprintf(setting, sizeof setting, "aside=%.9g", sqrt(1.0 - cosine * cosine));
    assert_true(parameters_assign(&gpu.renderer.parameters, setting));
    assert_true(renderer_probe(&gpu.renderer, &inputs, 1, 1, &probe));
    // Closer to the hit, the rounding of t as a float would dominate.
    for (int k = 0; k + 1 < probe.steps && hit - (double)probe.step[k].t > 3e-4; k++)
        rate = (hit - (double)probe.step[k + 1].t) / (hit - (double)probe.step[k].t);
    return rate;
}

TEST(test_rate_is_one_minus_the_cosine)
{
    assert_true(gpu_load_text(ball));
    for (double cosine = 0.05; cosine < 0.96; cosine += 0.05) {
        assert_true(fabs(measure_rate(cosine) - (1.0 - cosine)) < 1e-4);
        assert_true(fabs(rate_of_library(cosine) - (1.0 - cosine)) < 0.01);
    }
}

// The normal at the end of a march is that of the nearest point of the surface. At the silhouette,
// it differs from the normal at the point that the ray meets.
TEST(test_normal_at_the_foot_is_near)
{
    for (double radius = 0.1; radius < 2.0; radius *= 1.7)
        for (double threshold = 1e-5; threshold < 0.05; threshold *= 7.0) {
            double bound = acos(radius / (radius + threshold)) * 180.0 / MIRROR_PI;
            double worst = measure_foot(radius, threshold);
            assert_true(worst <= bound && worst > 0.7 * bound);
        }
    assert_near(measure_foot(1.0, 5e-4), 1.79, 0.02);
    assert_near(measure_foot(0.27, 5e-4), 3.39, 0.02);
}

// Counting pixels gives the radius to within about 0.1 pixels.
TEST(test_threshold_fattens_the_outline)
{
    for (double threshold = 0.001; threshold < 0.2; threshold *= 3.0)
        assert_true(fabs(measure_outline(threshold) - measure_outline_theory(threshold)) < 0.15);
}

TEST(test_offset_ends_the_acne)
{
    assert_true(measure_acne(0.0) > 0.9);
    assert_true(measure_acne(0.25) > 0.3);
    double one = measure_acne(1.0), four = measure_acne(4.0);
    assert_true(one >= 0.0 && one < 0.001 && four >= 0.0 && four < 0.001);
}

TESTS(gpu_setup, gpu_teardown)
