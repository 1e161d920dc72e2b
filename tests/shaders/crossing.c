// crossing.c - shaders/crossing.glsl towards random objects: the point where the distance falls to
// the threshold is known in closed form, or found by bisection in double precision.
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

//   row  0: marchCrossing, 1: marchCone
static struct crossing march_of(const float *values, int row, int number)
{
    const float *v = values + 4 * (row * CASES + number);
    // The views and the probe receive the end of the march; v[3] is -1 if they received another
    // threshold or spread.
    assert_true(v[0] == v[3]);
    return (struct crossing){(double)v[0], v[1] > 0.5f, (double)v[2]};
}

//   aside  distance of the point from the ray
//   start  the rays start at random positions from 0 to this; for a point, this far in front of it
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

// In front of a wall the end point is exact, wherever the march began; marchCone ends anywhere in
// front of it.
TEST(before_a_wall_it_is_exact)
{
    float *values = marches(WALL, 0.0, 4.0);
    double worst = 0.0, cone = 0.0;
    for (int i = 0; i < CASES; i++) {
        double slope = 0.05 + 0.95 * lot(i, 1);
        // slope (middle - t) = threshold + spread t
        double truth = (slope * middle_of(i) - threshold) / (slope + spread);
        struct crossing march = march_of(values, 0, i), other = march_of(values, 1, i);
        assert_true(march.found && other.found);
        // A float near 10 is accurate to 5e-7, and the distance about as accurate: divide by the
        // slope.
        worst = fmax(worst, slope * fabs(march.t - truth));
        cone = fmax(cone, slope * fabs(other.t - truth) / radius_at(truth));
    }
    free(values);
    print_message("# off by at most %.2g; marchCone by %.2f thresholds\n", worst, cone);
    assert_true(worst < 4e-6 && cone > 0.5);
}

// In front of a ball, the end point is where 0.7 r <= d <= r, because the distance is convex along
// the ray; and nearly where d = r. K is at most 1 / (1 + d).
TEST(before_a_ball_it_is_near)
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
    print_message("# |d - r| / r: mean %.4f, worst %.3f; marchCone's mean %.3f\n", sum / CASES,
                  worst, cone / CASES);
    assert_true(sum < 0.02 * CASES && sum < 0.1 * cone);
}

// From two starts on the same ray, both marches end at one point, but those of marchCone at two.
TEST(another_start_ends_in_the_same_place)
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
    print_message("# two starts end %.4f thresholds apart; of marchCone %.3f\n", apart[0],
                  apart[1]);
    assert_true(apart[0] < 0.1 * apart[1]);
}

// The march never steps over a point that is within 0.988 thresholds of the ray, and never hits one
// that is farther away than 1 threshold. marchCone misses some of the former.
TEST(thin_things_are_found)
{
    int passed = 0;
    for (int k = 0; k < 2; k++) {
        // The threshold at the point is smallest at 6 and largest at 10.
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
    print_message("# marchCone passes by %d of them\n", passed);
    assert_true(passed > 10);
}

// Slopes, some of which end in a surface and some above it: no surface is stepped over, and no
// returned point is nearer to one than 0.7 of the threshold before.
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

// The total of evaluations is hardly larger than marchCone's.
TEST(it_takes_little_more)
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
