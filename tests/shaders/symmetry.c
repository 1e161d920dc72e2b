// symmetry.c - shaders/symmetry.glsl on the GPU, compared with closest points on triangles, unions
// of 4^n tetrahedra and reflections, in double precision.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define SHADER "tests/shaders/symmetry.frag"
#define SIZE   0.75

enum { PLANES, EXACT, SIERPINSKI_PLANES, SIERPINSKI, REFLECT = 10, TO_CORNER = 11, RAYS = 20 };
enum { ITEMS_WIDE = 256, SLOTS = 4, ROWS = 32, ITEMS = ITEMS_WIDE * ROWS, MOST_LEVELS = 4 };

static const struct d3 corners[4] = {
    {1.0, 1.0, 1.0}, {1.0, -1.0, -1.0}, {-1.0, 1.0, -1.0}, {-1.0, -1.0, 1.0}};

static float *call(int function, float x, float y, float z, float w)
{
    return gpu_call(SHADER, ITEMS_WIDE * SLOTS, ROWS, function, (const float[4]){x, y, z, w});
}

// ---- The truth ----

static double segment_distance(struct d3 p, struct d3 a, struct d3 b)
{
    struct d3 along = d3_sub(b, a);
    double t = mirror_clamp(d3_dot(d3_sub(p, a), along) / d3_dot(along, along));
    return d3_length(d3_sub(p, d3_add(a, d3_times(t, along))));
}

// The distance from p to a triangle: to its plane if p projects onto the triangle, otherwise to the
// nearest edge.
static double triangle_distance(struct d3 p, const struct d3 v[3])
{
    struct d3 normal = d3_unit(d3_cross(d3_sub(v[1], v[0]), d3_sub(v[2], v[0])));
    double edge = HUGE_VAL;
    bool over = true;
    for (int i = 0; i < 3; i++) {
        struct d3 a = v[i], b = v[(i + 1) % 3];
        edge = fmin(edge, segment_distance(p, a, b));
        over = over && d3_dot(d3_cross(d3_sub(b, a), d3_sub(p, a)), normal) >= 0.0;
    }
    return over ? fabs(d3_dot(d3_sub(p, v[0]), normal)) : edge;
}

// The signed distance to the tetrahedron with the corners centre + size corners[i]: the distance to
// the nearest of its four triangles, negative if p is on the inner side of all four.
static double brute_tetrahedron(struct d3 p, struct d3 centre, double size)
{
    double nearest = HUGE_VAL;
    bool inside = true;
    for (int face = 0; face < 4; face++) {
        struct d3 v[3], opposite = d3_add(centre, d3_times(size, corners[face]));
        for (int i = 0; i < 3; i++)
            v[i] = d3_add(centre, d3_times(size, corners[(face + 1 + i) % 4]));
        struct d3 normal = d3_cross(d3_sub(v[1], v[0]), d3_sub(v[2], v[0]));
        double side = d3_dot(d3_sub(p, v[0]), normal);
        inside = inside && side * d3_dot(d3_sub(opposite, v[0]), normal) >= 0.0;
        nearest = fmin(nearest, triangle_distance(p, v));
    }
    return inside ? -nearest : nearest;
}

// The signed distance to the union of 4^levels tetrahedra, each of which is evaluated. The
// tetrahedra touch only at points, so the smallest of their signed distances is that of the union,
// even inside.
static double brute_union(struct d3 p, struct d3 centre, double size, int levels)
{
    if (levels == 0)
        return brute_tetrahedron(p, centre, size);
    double least = HUGE_VAL;
    for (int i = 0; i < 4; i++) {
        struct d3 part = d3_add(centre, d3_times(0.5 * size, corners[i]));
        least = fmin(least, brute_union(p, part, 0.5 * size, levels - 1));
    }
    return least;
}

static double brute(int function, struct d3 p, int levels)
{
    return brute_union(p, d3(0.0, 0.0, 0.0), SIZE, function < SIERPINSKI_PLANES ? 0 : levels);
}

// An upper bound on the rounding error of a distance. A fold adds three roundings of numbers no
// larger than |p| + 4 size and does not enlarge earlier errors; the tetrahedron at the end adds
// about six.
static double rounding(struct d3 p, int levels)
{
    return (6.0 + 3.0 * levels) * MIRROR_FLOAT_ROUNDING * (d3_length(p) + 4.0 * SIZE);
}

// ---- Distances ----

struct tally {
    int inside, outside;
    double least, most; // smallest and largest f / d outside
    double worst;       // largest |f - d| where f is exact, in units of the rounding bound
};

static bool is_exact(int function)
{
    return function == EXACT || function == SIERPINSKI;
}

static void check_point(int function, int levels, const float *slot, struct tally *tally)
{
    struct d3 p = d3_of(slot);
    double f = (double)slot[3], d = brute(function, p, levels), slack = rounding(p, levels);
    if (is_exact(function) || d <= 0.0)
        tally->worst = fmax(tally->worst, fabs(f - d) / slack);
    assert_true(d > 0.0 ? f >= d / 3.0 - slack && f <= d + slack : f <= slack);
    if (d > 1000.0 * slack) { // at smaller distances, rounding would affect f / d
        tally->least = fmin(tally->least, f / d);
        tally->most = fmax(tally->most, f / d);
    }
    tally->inside += d < 0.0;
    tally->outside += d > 0.0;
}

static struct tally check_function(int function, int levels)
{
    struct tally tally = {.least = HUGE_VAL};
    float *values = call(function, (float)levels, 0.0f, 0.0f, 1.0f);
    for (int i = 0; i < ITEMS; i++)
        check_point(function, levels, values + (size_t)4 * SLOTS * (size_t)i, &tally);
    free(values);
    print_message(
        "# function %d, n = %d: %d outside, %d inside, f/d from %.6f to %.6f, worst error "
        "%.2f times the rounding bound\n",
        function, levels, tally.outside, tally.inside, tally.least, tally.most, tally.worst);
    assert_true(tally.inside > 20 && tally.outside > 1000 && tally.worst <= 1.0);
    if (is_exact(function))
        assert_true(tally.least > 0.999 && tally.most < 1.001);
    else
        assert_true(tally.least < 0.334 && tally.least > 0.333 && tally.most > 0.999);
    return tally;
}

TEST(test_tetrahedra_agree_with_four_triangles)
{
    check_function(PLANES, 0);
    check_function(EXACT, 0);
}

TEST(test_pyramids_agree_with_the_union)
{
    for (int levels = 0; levels <= MOST_LEVELS; levels++) {
        check_function(SIERPINSKI_PLANES, levels);
        check_function(SIERPINSKI, levels);
    }
}

// The shader's distance f and the true distance d have the same zeros. f is 0 on the faces of every
// tetrahedron of the union; and where f is 0, d is also 0, because of the bound d / 3 <= f, which
// check_point asserts.
TEST(test_pyramids_vanish_on_the_surface)
{
    for (int function = PLANES; function <= SIERPINSKI; function++)
        for (int levels = 0; levels <= (function < SIERPINSKI_PLANES ? 0 : 10); levels += 5) {
            float *values = call(function, (float)levels, 0.0f, 0.0f, 2.0f);
            double worst = 0.0;
            for (int i = 0; i < ITEMS; i++) {
                const float *slot = values + (size_t)4 * SLOTS * (size_t)i;
                worst = fmax(worst, fabs((double)slot[3]) / rounding(d3_of(slot), levels));
            }
            free(values);
            print_message(
                "# function %d, n = %d: |f| on the surface at most %.2f times the rounding bound\n",
                function, levels, worst);
            assert_true(worst <= 1.0);
        }
}

// A tetrahedron fills a third of its cube, and each level leaves half of the volume. The number of
// random points inside may differ from the expected number by up to four standard deviations.
TEST(test_each_level_halves_the_volume)
{
    for (int levels = 0; levels <= 6; levels++) {
        float *values = call(SIERPINSKI_PLANES, (float)levels, 0.0f, 0.0f, 3.0f);
        int inside = 0;
        for (int i = 0; i < ITEMS; i++)
            inside += values[(size_t)4 * SLOTS * (size_t)i + 3] < 0.0f;
        free(values);
        double expected = ITEMS / 3.0 / (1 << levels), deviation = sqrt(expected);
        print_message("# n = %d: %d of %d points inside, %.1f expected\n", levels, inside,
                      (int)ITEMS, expected);
        assert_true(fabs(inside - expected) < 4.0 * deviation);
    }
}

TEST(test_distances_are_1_lipschitz)
{
    for (int function = PLANES; function <= SIERPINSKI; function++) {
        float *values = call(function, 10.0f, 0.0f, 0.0f, 1.0f);
        double largest = 0.0;
        for (int i = 0; i < ITEMS; i++) {
            const float *slot = values + (size_t)4 * SLOTS * (size_t)i;
            struct d3 p = d3_of(slot), q = d3_of(slot + 4);
            double apart = d3_length(d3_sub(p, q)),
                   change = fabs((double)slot[3] - (double)slot[7]);
            double slack = rounding(p, 10) + rounding(q, 10);
            assert_true(change <= apart + slack);
            if (apart > 1000.0 * slack)
                largest = fmax(largest, change / apart);
        }
        free(values);
        print_message("# function %d, n = 10: largest |f(p) - f(q)| / |p - q| is %.6f\n", function,
                      largest);
        assert_true(largest > 0.99 && largest <= 1.001);
    }
}

// ---- Folds ----

static struct d3 reflected(struct d3 p, struct d3 normal, double offset)
{
    return d3_sub(p, d3_times(2.0 * (d3_dot(p, normal) + offset), normal));
}

static double apart(struct d3 a, struct d3 b)
{
    return d3_length(d3_sub(a, b));
}

TEST(test_fold_keeps_one_side)
{
    const float n[3] = {0.48f, 0.6f, -0.64f}, offset = 0.3f;
    float *kept = call(REFLECT, n[0], n[1], n[2], offset);
    float *other = call(REFLECT, -n[0], -n[1], -n[2], -offset);
    int moved = 0;
    for (int i = 0; i < ITEMS; i++) {
        const float *slot = kept + (size_t)4 * SLOTS * (size_t)i;
        struct d3 p = d3_of(slot), got = d3_of(slot + 8), normal = d3_of(n);
        double side = d3_dot(p, normal) + (double)offset, slack = rounding(p, 1);
        bool behind = side < 0.0;
        assert_true(apart(got, behind ? reflected(p, normal, (double)offset) : p) <= slack);
        assert_true(d3_dot(got, normal) + (double)offset >= -slack);
        // With the signs of normal and offset changed, the plane is the same, but the other side is
        // kept.
        struct d3 mirrored = d3_of(other + (size_t)4 * SLOTS * (size_t)i + 8);
        assert_true(apart(mirrored, reflected(got, normal, (double)offset)) <= 2.0 * slack);
        moved += behind;
    }
    free(kept);
    free(other);
    assert_true(moved > ITEMS / 10 && moved < ITEMS - ITEMS / 10);
}

// foldToCorner is compared with three general folds, each in the plane halfway between the corner
// and another corner. After the three folds, the corner is the nearest of the four.
TEST(test_three_folds_lead_to_the_corner)
{
    float *values = call(TO_CORNER, 0.0f, 0.0f, 0.0f, 0.0f);
    for (int i = 0; i < ITEMS; i++) {
        const float *slot = values + (size_t)4 * SLOTS * (size_t)i;
        struct d3 q = d3_of(slot), got = d3_of(slot + 8), corner = d3_times(SIZE, corners[0]);
        double slack = rounding(q, 1);
        struct d3 p = d3_add(q, corner);
        for (int k = 3; k >= 1; k--) {
            struct d3 normal = d3_unit(d3_sub(corners[0], corners[k]));
            if (d3_dot(p, normal) < 0.0)
                p = reflected(p, normal, 0.0);
        }
        assert_true(apart(d3_sub(p, corner), got) <= slack);
        for (int k = 1; k < 4; k++)
            assert_true(d3_length(got) <=
                        apart(d3_add(got, corner), d3_times(SIZE, corners[k])) + slack);
    }
    free(values);
}

TEST(test_folds_are_1_lipschitz)
{
    const float numbers[2][4] = {{0.48f, 0.6f, -0.64f, 0.3f}, {0.0f, 0.0f, 0.0f, 0.0f}};
    for (int k = 0; k < 2; k++) {
        const float *v = numbers[k];
        float *values = call(k == 0 ? REFLECT : TO_CORNER, v[0], v[1], v[2], v[3]);
        double least = HUGE_VAL, most = 0.0;
        for (int i = 0; i < ITEMS; i++) {
            const float *slot = values + (size_t)4 * SLOTS * (size_t)i;
            struct d3 p = d3_of(slot), q = d3_of(slot + 4);
            double before = apart(p, q), after = apart(d3_of(slot + 8), d3_of(slot + 12));
            double slack = rounding(p, 1) + rounding(q, 1);
            assert_true(after <= before + slack);
            if (before > 1000.0 * slack) {
                least = fmin(least, after / before);
                most = fmax(most, after / before);
            }
        }
        free(values);
        print_message("# fold %d: |F(p) - F(q)| / |p - q| from %.4f to %.6f\n", k, least, most);
        assert_true(least < 0.9 && most > 0.999 && most < 1.001);
    }
}

// Behind the plane, the fold with a normal of length k multiplies lengths perpendicular to the
// plane by |1 - 2 k^2|.
TEST(test_a_normal_of_another_length_stretches)
{
    const float lengths[] = {0.70710678f, 1.0f, 1.3f, 1.41421356f};
    for (int k = 0; k < 4; k++) {
        float *values = call(REFLECT, 0.6f * lengths[k], 0.0f, 0.8f * lengths[k], 0.3f);
        double most = 0.0, length = (double)lengths[k];
        for (int i = 0; i < ITEMS; i++) {
            const float *slot = values + (size_t)4 * SLOTS * (size_t)i;
            double before = apart(d3_of(slot), d3_of(slot + 4));
            if (before > 0.01)
                most = fmax(most, apart(d3_of(slot + 8), d3_of(slot + 12)) / before);
        }
        free(values);
        double stretch = fabs(1.0 - 2.0 * length * length);
        print_message("# a normal of length %.4f: stretched by up to %.4f\n", length, most);
        assert_true(most < fmax(stretch, 1.0) + 0.001 && most > 0.98 * fmax(stretch, 1.0));
    }
}

TESTS(gpu_setup, gpu_teardown)
