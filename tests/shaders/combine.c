// combine.c - union, intersection and subtraction of two balls on the GPU, compared with the
// distance, in double precision, to the parts of the balls' surfaces that remain. The depth and the
// shares of smooth unions are tested too.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

enum { UNION, INTERSECTION, SUBTRACTION, SMOOTH, QUADRATIC };

enum { ROWS = 128, ITEMS = 256 * ROWS };

// Half the distance between the centres, the width of the blend, the step of the differences, and
// the radius. The distance and the radius are those of the discs in the experiment 04_bounds.frag.
static const float sizes[4] = {0.7f, 0.625f, 0.0078125f, 1.0f};
static const double shift = (double)0.7f, blend = 0.625, step = 0.0078125, radius = 1.0;

// An upper bound on the rounding errors of a distance, of the cube in a smooth union, and of a
// point's coordinates.
static const double slack = 2e-6;

static float *values_of(int operation)
{
    return gpu_call("tests/shaders/combine.frag", 1024, ROWS, operation, sizes);
}

// The distance from (x, y), relative to a ball's centre, to the arc of the ball's outline between
// two angles, both in [0, pi].
static double arc_distance(double x, double y, double from, double to)
{
    double angle = fmin(fmax(atan2(y, x), from), to);
    return hypot(x - radius * cos(angle), y - radius * sin(angle));
}

// The distance to the surface of the combination. Of each ball's outline, either the arc inside or
// the arc outside the other ball remains; the arcs meet in the plane midway between the centres, at
// the angle acos(shift / radius).
static double surface_distance(struct d3 p, int operation)
{
    double y = hypot(p.y, p.z), meet = acos(shift / radius);
    double left = operation == INTERSECTION ? arc_distance(p.x + shift, y, 0.0, meet)
                                            : arc_distance(p.x + shift, y, meet, MIRROR_PI);
    double right = operation == UNION ? arc_distance(shift - p.x, y, meet, MIRROR_PI)
                                      : arc_distance(shift - p.x, y, 0.0, meet);
    return fmin(left, right);
}

static bool inside(struct d3 p, int operation)
{
    bool left = hypot(p.x + shift, hypot(p.y, p.z)) < radius;
    bool right = hypot(p.x - shift, hypot(p.y, p.z)) < radius;
    if (operation == UNION)
        return left || right;
    return left && (operation == INTERSECTION ? right : !right);
}

// Compare an operator with the true distance. The operator is exact on one side; on the other, its
// absolute value is never larger than the distance, and smaller at some points.
static void check_bound(int operation, bool exact_inside)
{
    float *values = values_of(operation);
    int exact = 0, bounded = 0, short_of = 0;
    double shortest = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        struct d3 p = d3_of(values + 16 * i);
        double f = (double)values[16 * i + 3], truth = surface_distance(p, operation);
        bool in = inside(p, operation);
        if (truth > slack)
            assert_true((f < 0.0) == in);
        if (in == exact_inside) {
            assert_true(fabs(fabs(f) - truth) <= slack);
            exact++;
        } else {
            assert_true(fabs(f) <= truth + slack);
            bounded++;
            short_of += fabs(f) < truth - 0.01;
            shortest = fmax(shortest, truth - fabs(f));
        }
    }
    free(values);
    print_message(
        "# operation %d: exact at %d points; a bound at %d points, too small by more than 0.01 at "
        "%d of them, and by at most %.3f\n",
        operation, exact, bounded, short_of, shortest);
    assert_true(exact > 500 && bounded > 500 && short_of > 100);
}

TEST(test_union_is_exact_outside_and_a_bound_inside)
{
    check_bound(UNION, false);
}

TEST(test_intersection_is_exact_inside_and_a_bound_outside)
{
    check_bound(INTERSECTION, true);
}

TEST(test_subtraction_is_exact_inside_and_a_bound_outside)
{
    check_bound(SUBTRACTION, true);
}

// docs/04_hue_colour.md computes the distances at two points: above the lens, and in the middle of
// the union.
TEST(test_the_page_states_the_right_distances)
{
    struct d3 above = {0.0, 2.0, 0.0}, origin = {0.0, 0.0, 0.0};
    assert_true(fabs(surface_distance(above, INTERSECTION) - 1.286) < 5e-4);
    assert_true(fabs(hypot(shift, above.y) - radius - 1.119) < 5e-4);
    assert_true(fabs(surface_distance(origin, UNION) - 0.714) < 5e-4);
    assert_true(fabs(shift - radius - -0.3) < 5e-4);
}

TEST(test_all_combinations_are_1_lipschitz)
{
    for (int operation = UNION; operation <= QUADRATIC; operation++) {
        float *values = values_of(operation);
        double largest = 0.0;
        for (int i = 0; i < ITEMS; i++) {
            const float *v = values + 16 * i;
            double apart = d3_length(d3_sub(d3_of(v), d3_of(v + 4)));
            double change = fabs((double)v[3] - (double)v[7]);
            assert_true(change <= apart + slack);
            if (apart > 0.01)
                largest = fmax(largest, change / apart);
        }
        free(values);
        print_message("# operation %d: largest |f(p) - f(q)| / |p - q| is %.6f\n", operation,
                      largest);
        assert_true(largest > 0.99);
    }
}

// A smooth union is at most min(a, b) and at least min(a, b) minus the depth of the blend, which it
// reaches where a = b.
static void check_depth(int operation, double depth)
{
    float *values = values_of(operation);
    int middle = 0, outside = 0, between = 0;
    for (int i = 0; i < ITEMS; i++) {
        const float *v = values + 16 * i;
        double a = (double)v[8], b = (double)v[9], f = (double)v[3], least = fmin(a, b);
        assert_true(f <= least + slack && f >= least - depth - slack);
        if (v[0] == 0.0f) {
            assert_true(fabs(f - (least - depth)) <= slack);
            middle++;
        } else if (fabs(a - b) >= blend) {
            assert_true(fabs(f - least) <= slack);
            outside++;
        } else {
            between += f < least - 0.001;
        }
    }
    free(values);
    print_message("# operation %d: full depth at %d points, min(a, b) at %d, in between at %d\n",
                  operation, middle, outside, between);
    assert_true(middle > 1000 && outside > 1000 && between > 1000);
}

TEST(test_smooth_unions_lie_between_min_and_min_less_their_depth)
{
    check_depth(SMOOTH, blend / 6.0);
    check_depth(QUADRATIC, blend / 4.0);
}

// The share of b is the slope in b, and that of a is the slope in a. The slopes add up to 1,
// because adding h to both distances adds h to the union.
//   truncation  upper bound on the truncation error of the differences
static void check_share(int operation, double truncation)
{
    float *values = values_of(operation);
    double allowed = truncation + 1e-6 / step, worst = 0.0, sum = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        const float *v = values + 16 * i;
        double share = (double)v[10];
        double in_a = ((double)v[12] - (double)v[13]) / (2.0 * step);
        double in_b = ((double)v[14] - (double)v[15]) / (2.0 * step);
        assert_true(share >= 0.0 && share <= 1.0);
        worst = fmax(worst, fmax(fabs(in_b - share), fabs(in_a - (1.0 - share))));
        sum = fmax(sum, fabs(in_a + in_b - 1.0));
        if (v[0] == 0.0f)
            assert_true(fabs(share - 0.5) < 1e-5);
    }
    free(values);
    print_message(
        "# operation %d: the share differs from the slope by at most %.2g (allowed: %.2g); "
        "the slopes add up to 1 within %.2g\n",
        operation, worst, allowed, sum);
    assert_true(worst <= allowed && sum <= allowed);
}

// The cubic's third derivative is at most 1 / k^2, even where it jumps, at a = b. The quadratic's
// second derivative jumps by 1 / (2 k) where the blend begins.
TEST(test_shares_are_the_slopes)
{
    check_share(SMOOTH, step * step / (6.0 * blend * blend));
    check_share(QUADRATIC, step / (8.0 * blend));
}

TESTS(gpu_setup, gpu_teardown)
