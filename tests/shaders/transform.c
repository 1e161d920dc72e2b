// transform.c - shaders/transform.glsl: under rigid maps and scaling, distances stay exact; under
// linear maps, they are safe when divided by the largest stretch.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/matrix.h"

#define SHADER "tests/shaders/transform.frag"

enum {
    TURNED_BOX,
    SCALED_BOX,
    SQUEEZED_BALL,
    TORUS,
    TWIST = 10,
    BEND,
    MATRICES = 20,
    TURN,
    STRETCH
};
enum { WIDE = 256, ROWS = 64, ITEMS = WIDE * ROWS, SLOTS = 4 };

static const struct d3 half = {0.75, 0.5, 1.25}, shift = {0.5, -0.25, 1.0};

// The shader's results for ITEMS items: 4 slots of 4 floats each. The caller frees them.
static float *ask(int function, float a, float b, float c)
{
    return gpu_call(SHADER, WIDE * SLOTS, ROWS, function, (const float[4]){a, b, c});
}

// ---- Isometries ----

// The distance from p to the closest point of a box with the centre `shift`, the half sizes `half`
// and the given axes. The distance is negative inside.
static double brute_turned_box(struct d3 p, const struct m3 *axes)
{
    struct d3 from = d3_sub(p, shift), closest = shift;
    double local[3], size[3] = {half.x, half.y, half.z}, depth = INFINITY;
    for (int i = 0; i < 3; i++) {
        local[i] = d3_dot(from, axes->column[i]);
        depth = fmin(depth, size[i] - fabs(local[i]));
        double clamped = fmax(-size[i], fmin(size[i], local[i]));
        closest = d3_add(closest, d3_times(clamped, axes->column[i]));
    }
    return depth > 0.0 ? -depth : d3_length(d3_sub(p, closest));
}

TEST(test_a_moved_and_turned_box_is_exact)
{
    static const float angles[][3] = {
        {0.0f, 0.0f, 0.0f}, {0.7f, 0.0f, 0.0f}, {0.5f, -0.7f, 0.3f}, {2.5f, 1.2f, -3.0f}};
    double worst = 0.0;
    for (int k = 0; k < 4; k++) {
        const float *a = angles[k];
        struct m3 axes = m3_rotation((double)a[0], (double)a[1], (double)a[2]);
        float *values = ask(TURNED_BOX, a[0], a[1], a[2]);
        int inside = 0;
        for (int i = 0; i < ITEMS; i++) {
            const float *v = values + 16 * i;
            double truth = brute_turned_box(d3_of(v), &axes);
            worst = fmax(worst, fabs((double)v[3] - truth));
            inside += truth < 0.0;
        }
        free(values);
        assert_true(inside > 100 && inside < ITEMS / 2);
    }
    print_message("# a moved and turned box, 4 x %d points: off by at most %.2g\n", ITEMS, worst);
    assert_true(worst < 4e-6);
}

TEST(test_rotations_are_orthonormal)
{
    double worst = 0.0;
    for (int k = 0; k < 40; k++) {
        double a = 0.37 * k - 7.0, b = 0.91 * k - 3.0, c = 1.7 - 0.53 * k;
        float *v = ask(TURN, (float)a, (float)b, (float)c);
        struct m3 got = {{d3_of(v), d3_of(v + 4), d3_of(v + 8)}};
        struct m3 truth = m3_rotation((double)(float)a, (double)(float)b, (double)(float)c);
        free(v);
        for (int i = 0; i < 3; i++) {
            worst = fmax(worst, d3_length(d3_sub(got.column[i], truth.column[i])));
            struct d3 back = m3_apply_transposed(&got, m3_apply(&got, truth.column[i]));
            worst = fmax(worst, d3_length(d3_sub(back, truth.column[i])));
        }
        worst = fmax(worst, fabs(m3_determinant(&got) - 1.0));
    }
    print_message("# 40 rotations: matrix, R^T R and det R off by at most %.2g\n", worst);
    assert_true(worst < 2e-5);
    // A quarter turn about x takes y to z.
    float *x = ask(TURN, (float)(MIRROR_PI / 2.0), 0.0f, 0.0f);
    assert_true(d3_length(d3_sub(d3_of(x + 4), d3(0.0, 0.0, 1.0))) < 1e-6);
    free(x);
}

// The rotation by angles in degrees, as the library defines it.
static struct m3 turned(double a, double b, double c)
{
    double k = MIRROR_PI / 180.0;
    float *v = ask(TURN, (float)(k * a), (float)(k * b), (float)(k * c));
    struct m3 matrix = {{d3_of(v), d3_of(v + 4), d3_of(v + 8)}};
    free(v);
    return matrix;
}

// The angle, in degrees, of the rotation that remains if the report's 'inverse', with negated
// angles, follows a rotation. The cosine of a small angle loses its digits in single precision, so
// the sine is used too.
static double residual(double a, double b, double c)
{
    struct m3 there = turned(a, b, c), back = turned(-a, -b, -c);
    struct d3 x = m3_apply(&back, there.column[0]), y = m3_apply(&back, there.column[1]),
              z = m3_apply(&back, there.column[2]);
    double sine2 = d3_length(d3(y.z - z.y, z.x - x.z, x.y - y.x)); // twice the sine
    return atan2(sine2, x.x + y.y + z.z - 1.0) * 180.0 / MIRROR_PI;
}

// An estimate of the residual for small angles, from docs/05_transforms.md: it consists of products
// of two angles.
static double estimated(double a, double b, double c)
{
    return sqrt(b * c * b * c + a * c * a * c + a * b * a * b) * MIRROR_PI / 180.0;
}

TEST(test_negated_angles_are_no_inverse)
{
    double left = residual(30.0, 40.0, 20.0), worse = residual(90.0, 90.0, 0.0);
    print_message(
        "# remaining after negated angles: %.1f degrees at (30, 40, 20), %.1f at (90, 90, 0)\n",
        left, worse);
    assert_true(fabs(left - 26.1) < 0.05 && fabs(worse - 120.0) < 1e-4);
    double small = residual(5.0, 5.0, 5.0), estimate = estimated(5.0, 5.0, 5.0);
    print_message("# at (5, 5, 5): %.3f degrees, estimated %.3f; at (30, 40, 20) estimated %.1f\n",
                  small, estimate, estimated(30.0, 40.0, 20.0));
    assert_true(fabs(small - 0.7548) < 0.0001 && fabs(small / estimate - 1.0) < 0.05);
    assert_true(fabs(estimated(30.0, 40.0, 20.0) - 27.3) < 0.05);
    // If only one angle is not 0, negating it gives the exact inverse.
    assert_true(residual(30.0, 0.0, 0.0) < 1e-4 && residual(0.0, 0.0, -70.0) < 1e-4);
    // In the report's printed matrix, a term in row 1, column 2 is missing.
    double k = MIRROR_PI / 180.0;
    struct m3 printed = turned(30.0, 40.0, 20.0);
    double missing = -cos(30.0 * k) * sin(20.0 * k);
    printed.column[1].x -= missing;
    print_message(
        "# the report's printed matrix at (30, 40, 20): determinant %.3f, largest stretch %.3f\n",
        m3_determinant(&printed), m3_largest_stretch(&printed));
    assert_true(fabs(m3_largest_stretch(&printed) - 1.160) < 0.001);
}

// ---- Scaling and linear maps ----

TEST(test_scaling_is_exact_with_the_factor_outside)
{
    static const float factors[] = {0.25f, 0.5f, 3.0f};
    for (int k = 0; k < 3; k++) {
        double factor = (double)factors[k], worst = 0.0, without = 0.0;
        float *values = ask(SCALED_BOX, factors[k], 0.0f, 0.0f);
        for (int i = 0; i < ITEMS; i++) {
            const float *v = values + 16 * i;
            double truth = brute_box(d3_of(v), d3_times(factor, half)), f = (double)v[3];
            worst = fmax(worst, fabs(f - truth));
            if (truth > 0.01)
                without = fmax(without, f / factor / truth);
        }
        free(values);
        print_message("# scaled by %.2f: off by at most %.2g; without the factor up to %.2f times "
                      "the distance\n",
                      factor, worst, without);
        assert_true(worst < 4e-6 && fabs(without * factor - 1.0) < 0.01);
    }
}

// The signed distance to the spheroid 4 x^2 + y^2 + z^2 = 1, in the half-plane of x and rho: first
// find the nearest of many points of the ellipse, and then use a ternary search between its
// neighbours.
static double brute_spheroid(struct d3 p)
{
    enum { COUNT = 200 };
    double x = fabs(p.x), rho = hypot(p.y, p.z), step = 0.5 * MIRROR_PI / COUNT, at = 0.0;
    double best = INFINITY;
    for (int i = 0; i <= COUNT; i++) {
        double away = hypot(x - 0.5 * cos(i * step), rho - sin(i * step));
        at = away < best ? i * step : at;
        best = fmin(best, away);
    }
    double low = at - step, high = at + step;
    for (int i = 0; i < 60; i++) {
        double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        bool nearer = hypot(x - 0.5 * cos(a), rho - sin(a)) < hypot(x - 0.5 * cos(b), rho - sin(b));
        high = nearer ? b : high;
        low = nearer ? low : a;
    }
    best = hypot(x - 0.5 * cos(low), rho - sin(low));
    return 4.0 * x * x + rho * rho < 1.0 ? -best : best;
}

TEST(test_the_largest_singular_value_makes_a_linear_map_safe)
{
    float *values = ask(SQUEEZED_BALL, 0.0f, 0.0f, 0.0f);
    double largest = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        const float *v = values + 16 * i;
        double truth = brute_spheroid(d3_of(v));
        if (truth > 0.001)
            largest = fmax(largest, (double)v[3] / truth);
        else if (truth < -0.001)
            assert_true((double)v[3] >= truth - 1e-6);
    }
    free(values);
    print_message("# M = diag(2, 1, 1): at most %.4f times the distance; undivided %.4f times\n",
                  largest, 2.0 * largest);
    assert_true(largest <= 1.0001 && largest > 0.98);
}

TEST(test_largest_stretch_agrees_with_squaring)
{
    float *values = ask(MATRICES, 0.5f, 1.0f, -2.0f);
    double worst = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        const float *v = values + 16 * i;
        struct m3 m = {{d3_of(v), d3_of(v + 4), d3_of(v + 8)}};
        worst = fmax(worst, fabs((double)v[12] / m3_largest_stretch(&m) - 1.0));
        assert_true(fabs((double)v[13] - 1.0) < 1e-3); // the stretch of a rotation
    }
    free(values);
    print_message("# largestStretch of %d matrices: relative error %.2g\n", ITEMS, worst);
    assert_true(worst < 2e-4);
}

// ---- The torus ----

// The signed distance to a torus: the distance to the nearest point of the circle in the middle of
// the tube, found by a search, minus the radius of the tube.
static double brute_torus(struct d3 p, double radius, double tube)
{
    double best = INFINITY, at = 0.0, width = 0.1;
    for (int i = 0; i < 64; i++) {
        double angle = 2.0 * MIRROR_PI * i / 64.0;
        double away = d3_length(d3_sub(p, d3(radius * cos(angle), 0.0, radius * sin(angle))));
        at = away < best ? angle : at;
        best = fmin(best, away);
    }
    for (int round = 0; round < 40; round++, width *= 0.6)
        for (int side = -1; side <= 1; side += 2) {
            double angle = at + side * width;
            double away = d3_length(d3_sub(p, d3(radius * cos(angle), 0.0, radius * sin(angle))));
            at = away < best ? angle : at;
            best = fmin(best, away);
        }
    return best - tube;
}

TEST(test_torus_is_exact)
{
    float *values = ask(TORUS, 1.0f, 0.26f, 0.0f);
    double worst = 0.0;
    int inside = 0;
    for (int i = 0; i < ITEMS; i++) {
        const float *v = values + 16 * i;
        double truth = brute_torus(d3_of(v), 1.0, (double)0.26f);
        worst = fmax(worst, fabs((double)v[3] - truth));
        inside += truth < 0.0;
    }
    free(values);
    print_message("# torus, %d points, %d inside: off by at most %.2g\n", ITEMS, inside, worst);
    assert_true(worst < 2e-6 && inside > 30);
}

TESTS(gpu_setup, gpu_teardown)
