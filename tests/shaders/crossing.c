// crossing.c - marches of shaders/crossing.glsl towards random objects, whose distances along the
// ray are computed in double precision.
#include "lib/test.h"
#include "lib/cell.h"
#include "lib/gpu.h"

#define SHADER "tests/shaders/crossing.frag"

enum { POINT, WALL, BALL, SLOPES };
enum { CASES = 2048 };

static const double threshold = 0.01, spread = 0.002, far = 20.0;

struct crossing {
    double t;
    bool found;
    double evaluations;
};

// The result of one march.
//   row  0 for marchCrossing, 1 for marchCone
static struct crossing march_of(const float *values, int row, int number)
{
    const float *v = values + 4 * (row * CASES + number);
    // v[3] is the end of the march as the views and the probe receive it, or -1 if they received
    // another threshold or spread.
    assert_true(v[0] == v[3]);
    return (struct crossing){(double)v[0], v[1] > 0.5f, (double)v[2]};
}

// March towards CASES objects with both marches. Returns four numbers per march, which the caller
// frees.
//   aside  distance of the point from the ray
//   start  each march begins at a random t in [0, start), or, for a point, that far in front of it
static float *marches(int function, double aside, double start)
{
    const float numbers[4] = {(float)threshold, (float)spread, (float)aside, (float)start};
    return gpu_call(SHADER, CASES, 2, function, numbers);
}

static double lot(int number, int dimension)
{
    return cell_hash(number, 0, dimension);
}

static double middle_of(int number)
{
    return 6.0 + 4.0 * lot(number, 0);
}

static double radius_at(double t)
{
    return threshold + spread * t;
}

static double ball_distance(int number, double t)
{
    return hypot(middle_of(number) - t, 0.98 * lot(number, 1)) - 1.0;
}

// In front of a wall, marchCrossing ends exactly at the threshold, wherever it began; marchCone may
// end anywhere within the threshold.
TEST(a_march_to_a_wall_ends_exactly_at_the_threshold)
{
    float *values = marches(WALL, 0.0, 4.0);
    double worst = 0.0, cone = 0.0;
    for (int i = 0; i < CASES; i++) {
        double slope = 0.05 + 0.95 * lot(i, 1);
        // At the true end, slope (middle - t) = threshold + spread t.
        double truth = (slope * middle_of(i) - threshold) / (slope + spread);
        struct crossing march = march_of(values, 0, i), other = march_of(values, 1, i);
        assert_true(march.found && other.found);
        // A float near 10 is accurate to 5e-7, and the distance about as accurate. The error of t
        // is that of the distance divided by the slope.
        worst = fmax(worst, slope * fabs(march.t - truth));
        cone = fmax(cone, slope * fabs(other.t - truth) / radius_at(truth));
    }
    free(values);
    print_message("# the end is off by at most %.2g; with marchCone by up to %.2f thresholds\n",
                  worst, cone);
    assert_true(worst < 4e-6 && cone > 0.5);
}

// In front of a ball, the march ends where 0.7 r <= d <= r for the distance d and the threshold r,
// because the distance is convex along the ray; the end is close to the point where d = r. The
// second derivative of d is at most 1 / (1 + d).
TEST(a_march_to_a_ball_ends_near_the_threshold)
{
    float *values = marches(BALL, 0.0, 4.0);
    double worst = 0.0, sum = 0.0, cone = 0.0;
    for (int i = 0; i < CASES; i++) {
        struct crossing march = march_of(values, 0, i), other = march_of(values, 1, i);
        double d = ball_distance(i, march.t), r = radius_at(march.t);
        assert_true(march.found && other.found);
        assert_true(d <= r + 1e-5 && d >= 0.7 * r - 2e-5);
        worst = fmax(worst, fabs(d - r) / r);
        sum += fabs(d - r) / r;
        cone += fabs(ball_distance(i, other.t) - radius_at(other.t)) / radius_at(other.t);
    }
    free(values);
    print_message("# |d - r| / r: mean %.4f, largest %.3f; mean with marchCone %.3f\n", sum / CASES,
                  worst, cone / CASES);
    assert_true(sum < 0.02 * CASES && sum < 0.1 * cone);
}

// From two starts on the same ray, marchCrossing ends at nearly the same point, but marchCone at
// two different points.
TEST(a_march_from_another_start_ends_at_the_same_point)
{
    float *first = marches(BALL, 0.0, 0.0), *second = marches(BALL, 0.0, 4.0);
    double apart[2] = {0.0, 0.0};
    for (int i = 0; i < CASES; i++)
        for (int row = 0; row < 2; row++) {
            struct crossing one = march_of(first, row, i), other = march_of(second, row, i);
            apart[row] += fabs(one.t - other.t) / radius_at(one.t) / CASES;
        }
    free(first);
    free(second);
    print_message(
        "# from two starts, the ends are %.4f thresholds apart on average; with marchCone %.3f\n",
        apart[0], apart[1]);
    assert_true(apart[0] < 0.1 * apart[1]);
}

// marchCrossing never steps over a point that is within 0.988 thresholds of the ray, and never
// finds a point that is more than 1 threshold away. marchCone misses some of the former.
TEST(thin_objects_are_found)
{
    int passed = 0;
    for (int k = 0; k < 2; k++) {
        // The points are at t from 6 to 10, and the threshold grows with t.
        double aside = k == 0 ? 0.988 * radius_at(6.0 - 0.05) : 1.001 * radius_at(10.0 + 0.05);
        float *values = marches(POINT, aside, 0.2);
        for (int i = 0; i < CASES; i++) {
            struct crossing march = march_of(values, 0, i);
            assert_true(march.found == (k == 0));
            assert_true(k == 1 || march.t <= middle_of(i) + 1e-5);
            passed += k == 0 && lot(i, 0) < 0.05 && !march_of(values, 1, i).found;
        }
        free(values);
    }
    print_message("# marchCone misses %d of the points at t < 6.2\n", passed);
    assert_true(passed > 10);
}

// Along these rays, the distance falls to a minimum and rises again; some of the minima are
// negative. The march never passes a minimum of less than 0.7 thresholds, and never returns a point
// with a distance of less than 0.7 times the threshold that applies half a unit before this point.
TEST(no_surface_is_passed)
{
    float *values = marches(SLOPES, 0.0, 4.0);
    int hits = 0, misses = 0;
    for (int i = 0; i < CASES; i++) {
        struct crossing march = march_of(values, 0, i);
        double slope = 0.05 + 0.95 * lot(i, 1), least = 0.06 * (lot(i, 2) - 0.3);
        double d = slope * fabs(march.t - middle_of(i)) + least;
        assert_true(march.found || least > 0.7 * radius_at(6.0));
        assert_true(!march.found || least < radius_at(10.0));
        if (march.found)
            assert_true(march.t <= middle_of(i) + 0.6 &&
                        d >= 0.7 * radius_at(march.t - 0.5) - 2e-5);
        else
            assert_true(march.t >= far);
        hits += march.found;
        misses += !march.found;
    }
    free(values);
    print_message("# %d hits, %d misses\n", hits, misses);
    assert_true(hits > 1000 && misses > 500);
}

// On average, marchCrossing takes at most three more evaluations than marchCone.
TEST(the_march_takes_few_more_evaluations)
{
    float *values = marches(WALL, 0.0, 4.0);
    double sum[2] = {0.0, 0.0};
    for (int i = 0; i < CASES; i++)
        for (int row = 0; row < 2; row++)
            sum[row] += march_of(values, row, i).evaluations / CASES;
    free(values);
    print_message("# %.2f evaluations, marchCone %.2f\n", sum[0], sum[1]);
    assert_true(sum[0] >= sum[1] && sum[0] < sum[1] + 3.0);
}

TESTS(gpu_setup, gpu_teardown)
