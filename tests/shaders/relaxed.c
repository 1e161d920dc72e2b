// relaxed.c - shaders/relaxed.glsl with random distances, whose surfaces are known in closed form;
// shaders/stretch.glsl compared with slopes in double precision.
#include "lib/test.h"
#include "lib/cell.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define SHADER "tests/shaders/relaxed.frag"

enum { LINES, POINTS, STRETCH, WALL };
enum { CASES = 2048, THINGS = 8 };

static const double far = 12.0, spread = 0.001;
static const float omegas[] = {1.05f, 1.2f, 1.5f, 1.8f, 1.95f};
enum { OMEGAS = sizeof omegas / sizeof *omegas };

// The distance of function 0 of the shader, in double precision.
static double line_distance(int number, double x)
{
    double nearest = 3.0;
    for (int i = 0; i < THINGS; i++) {
        double slope = 0.05 + 0.95 * cell_hash(number, i, 1);
        double least = 0.3 * cell_hash(number, i, 2) - 0.05;
        nearest = fmin(nearest, slope * fabs(x - 12.0 * cell_hash(number, i, 0)) + least);
    }
    return nearest;
}

// The distance along the ray to the first surface: an object whose smallest distance is not above 0
// begins at a known point.
static double line_surface(int number)
{
    double first = HUGE_VAL;
    for (int i = 0; i < THINGS; i++) {
        double slope = 0.05 + 0.95 * cell_hash(number, i, 1);
        double least = 0.3 * cell_hash(number, i, 2) - 0.05;
        if (least <= 0.0)
            first = fmin(first, fmax(12.0 * cell_hash(number, i, 0) + least / slope, 0.0));
    }
    return first;
}

// True if the distance stays below the threshold all the way from a point to the surface.
// Otherwise, a march may stop there or pass, depending on its steps.
static bool sure(int number, double from, double surface, double threshold)
{
    for (int i = 0; i <= 64 && surface < far; i++) {
        double x = from + (surface - from) * i / 64.0;
        if (line_distance(number, x) >= threshold + spread * x)
            return false;
    }
    return surface < far;
}

struct relaxed_march {
    double t;
    bool found;
    int evaluations;
};

static struct relaxed_march march_of(const float *values, int row, int number)
{
    const float *v = values + 4 * (row * CASES + number);
    return (struct relaxed_march){(double)v[0], v[1] > 0.5f, (int)v[2]};
}

static float *marches(int function, float threshold, float omega, float aside)
{
    const float numbers[4] = {0.0f, threshold, omega, aside};
    return gpu_call(SHADER, CASES, 2, function, numbers);
}

// No step passes a surface, every hit is near the scene, and every miss is a true miss.
TEST(no_surface_is_passed)
{
    const double threshold = 0.002, rounding = 2e-5;
    int hits = 0, misses = 0;
    for (int k = 0; k < OMEGAS; k++) {
        float *values = marches(LINES, (float)threshold, omegas[k], 0.0f);
        for (int i = 0; i < CASES; i++) {
            struct relaxed_march march = march_of(values, 0, i);
            double surface = line_surface(i);
            assert_true(march.t <= fmin(surface, march.found ? far : HUGE_VAL) + rounding);
            if (march.found)
                assert_true(line_distance(i, march.t) < threshold + spread * march.t + rounding);
            else
                assert_true(surface >= far - rounding && march.t >= far);
            hits += march.found;
            misses += !march.found;
        }
        free(values);
    }
    print_message("# %d hits, %d misses\n", hits, misses);
    assert_true(hits > 1000 && misses > 1000);
}

// Where marchCone takes n evaluations, marchRelaxed takes at most n + 1. With a factor of up to
// 1.5, it takes fewer in total.
TEST(a_relaxed_march_takes_at_most_one_extra_evaluation)
{
    const double threshold = 0.002;
    for (int k = 0; k < OMEGAS; k++) {
        float *values = marches(LINES, (float)threshold, omegas[k], 0.0f);
        long all = 0, plain_all = 0;
        int worst = 0, compared = 0;
        for (int i = 0; i < CASES; i++) {
            struct relaxed_march march = march_of(values, 0, i), plain = march_of(values, 1, i);
            if (plain.found && !sure(i, plain.t, line_surface(i), threshold))
                continue;
            int more = march.evaluations - plain.evaluations;
            worst = more > worst ? more : worst;
            compared++;
            all += march.evaluations;
            plain_all += plain.evaluations;
        }
        free(values);
        print_message("# omega %.2f: %d rays, %.3f times the evaluations of marchCone, at most %d "
                      "more for one ray\n",
                      (double)omegas[k], compared, (double)all / (double)plain_all, worst);
        assert_true(worst == 1 && compared > CASES / 2);
        assert_true(omegas[k] > 1.5f || all < plain_all);
    }
}

// With omega 1, the relaxed march equals marchCone to the last bit.
TEST(a_relaxed_march_with_a_factor_of_1_is_march_cone)
{
    for (int function = LINES; function <= POINTS; function++) {
        float *values = marches(function, 0.01f, 1.0f, 0.02f);
        for (int i = 0; i < CASES; i++)
            for (int k = 0; k < 4; k++)
                assert_true(values[4 * i + k] == values[4 * (CASES + i) + k]);
        free(values);
    }
}

// Neither marchRelaxed nor marchCone ever steps over a point that is nearer to the ray than 0.86
// thresholds.
TEST(thin_objects_are_found)
{
    const float threshold = 0.02f;
    for (int k = 0; k < OMEGAS; k++) {
        float *values = marches(POINTS, threshold, omegas[k], 0.85f * threshold);
        for (int i = 0; i < CASES; i++) {
            double middle = 12.0 * cell_hash(i, 0, 0);
            for (int row = 0; row < 2; row++) {
                struct relaxed_march march = march_of(values, row, i);
                assert_true(march.found && march.t <= middle + 0.03);
            }
        }
        free(values);
    }
}

// Towards a wall, one step is too long and costs one extra evaluation. Along a wall, the number of
// evaluations is divided by omega.
TEST(the_worst_and_the_best_case_cost_what_is_stated)
{
    const float ahead[4] = {0.0f, 0.001f, 1.5f, 0.0f}, beside[4] = {0.1f, 0.001f, 1.6f, 0.0f};
    float *values = gpu_call(SHADER, CASES, 2, WALL, ahead);
    struct relaxed_march march = march_of(values, 0, 0), plain = march_of(values, 1, 0);
    free(values);
    assert_int_equal(plain.evaluations, 2);
    assert_int_equal(march.evaluations, 3);
    assert_true(march.found && fabs(march.t - 1.0) < 1e-6);
    values = gpu_call(SHADER, CASES, 2, WALL, beside);
    march = march_of(values, 0, 0);
    plain = march_of(values, 1, 0);
    free(values);
    assert_true(abs(plain.evaluations - 100) <= 1 && abs(march.evaluations - 63) <= 1);
}

// ---- Stretches ----

// The largest |J v| over the points of the cylinder, where J is the derivative of the twist.
static double twist_truth(double rate, double radius, struct d3 v)
{
    double largest = 0.0;
    for (int i = 0; i < 720; i++) {
        double angle = MIRROR_PI * i / 360.0, x = radius * cos(angle), z = radius * sin(angle);
        // At height 0, the twist is (x + rate y z, y, z - rate y x) to first order.
        struct d3 moved = d3(v.x + rate * z * v.y, v.y, v.z - rate * x * v.y);
        largest = fmax(largest, d3_length(moved));
    }
    return largest;
}

TEST(stretches_are_the_largest_slopes)
{
    const float numbers[4] = {1.7f, 0.4f, 0.0f, 0.0f};
    float *values = gpu_call(SHADER, CASES, 2, STRETCH, numbers);
    double height = 0.0, twist = 0.0, worst = 0.0;
    for (int i = 0; i < CASES; i++) {
        struct d3 v = d3_of(values + 4 * i);
        double along = (double)values[4 * i + 3], turned = (double)values[4 * (CASES + i) + 3];
        // Along v, y - h changes by v_y - grad h . (v_x, v_z). The gradient may have any direction.
        double most = 0.0;
        for (int k = 0; k < 720; k++) {
            double angle = MIRROR_PI * k / 360.0;
            double slope = (double)numbers[0] * (cos(angle) * v.x + sin(angle) * v.z);
            most = fmax(most, fabs(v.y - slope));
        }
        worst = fmax(worst, fabs(along - most));
        worst = fmax(worst, fabs(turned - twist_truth((double)numbers[0], (double)numbers[1], v)));
        height = fmax(height, along);
        twist = fmax(twist, turned);
        assert_true(turned >= 1.0 - 1e-6);
    }
    free(values);
    double u = (double)numbers[0] * (double)numbers[1];
    double all = sqrt(1.0 + (double)numbers[0] * (double)numbers[0]);
    print_message(
        "# stretches: worst error %.2g; largest of the height field %.4f, of the twist %.4f\n",
        worst, height, twist);
    assert_true(worst < 1e-4);
    assert_true(height <= all + 1e-6 && height > 0.999 * all);
    assert_true(twist <= 0.5 * (u + sqrt(u * u + 4.0)) + 1e-6 &&
                twist > 0.499 * (u + sqrt(u * u + 4.0)));
}

TESTS(gpu_setup, gpu_teardown)
