// rays.c - the library's march, bounds, normal and shadow ray on the GPU, compared with analytic
// intersections in double precision.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

enum { ITEMS_WIDE = 256, SLOTS = 4, ROWS = 128, ITEMS = ITEMS_WIDE * ROWS };
enum {
    BALL = 0,
    PLANE = 1,
    NOTHING = 3,
    INTERVAL = 10,
    NORMAL_BALL = 20,
    NORMAL_BOX = 22,
    SHADOW = 30
};

static float *rays(int function, float x, float y, float z, float w)
{
    return gpu_call("tests/shaders/rays.frag", ITEMS_WIDE * SLOTS, ROWS, function,
                    (const float[4]){x, y, z, w});
}

// The result of one march, as the shader writes it.
struct marched {
    struct mirror_ray ray;
    bool unit; // the ray's direction has length 1
    double t;
    bool found;
    int end, evaluations, steps, all_steps, marches;
};

static struct marched unpack(const float *values, int item)
{
    const float *v = values + 4 * SLOTS * item;
    struct marched m = {.ray = {d3_of(v), d3_of(v + 4)}};
    m.unit = fabs(d3_length(m.ray.direction) - 1.0) < 1e-6;
    m.t = (double)v[8];
    m.found = v[9] > 0.5f;
    m.end = (int)v[10];
    m.evaluations = (int)v[11];
    m.steps = (int)v[12];
    m.all_steps = (int)v[13];
    m.marches = (int)v[14];
    return m;
}

// An upper bound on the rounding error of a distance at t. The position and the distance are each
// off by about three roundings of a number no larger than |origin| + t + 1; eight in total are
// allowed.
static double slack_of(const struct marched *m)
{
    return 8.0 * MIRROR_FLOAT_ROUNDING * (d3_length(m->ray.origin) + fabs(m->t) + 1.0);
}

static void check_counts(const struct marched *m)
{
    assert_int_equal(m->evaluations, m->steps);
    assert_int_equal(m->all_steps, m->steps);
    assert_int_equal(m->marches, 1);
    assert_true(m->found == (m->end == MIRROR_HIT));
}

// A hit is at most threshold / |cos| in front of the surface: the ball is convex, so along the ray
// the distance to it is at least the distance to its tangent plane at the true t.
static void check_hit(const struct marched *m, double t, double cosine, double threshold)
{
    double slack = slack_of(m) / cosine;
    assert_true(m->t <= t + slack);
    assert_true(m->t >= t - threshold / cosine - slack);
}

TEST(test_march_meets_a_ball_where_it_is)
{
    const float threshold = 0.001f;
    float *values = rays(BALL, 20.0f, threshold, 512.0f, 0.0f);
    int hits = 0, misses = 0, close = 0, inside = 0;
    for (int i = 0; i < ITEMS; i++) {
        struct marched m = unpack(values, i);
        double t[2], start = d3_length(m.ray.origin) - 1.0;
        if (!m.unit)
            continue;
        check_counts(&m);
        double along = fmax(-d3_dot(m.ray.origin, m.ray.direction), 0.0);
        double least = d3_length(mirror_at(m.ray, along)) - 1.0;
        if (start < 0.0) {
            assert_true(m.found && m.t == 0.0 && m.steps == 1);
            inside++;
        } else if (mirror_ball_crossing(m.ray, 1.0, t) && t[0] > 0.0 && least < -slack_of(&m)) {
            assert_true(m.found);
            struct d3 normal = mirror_at(m.ray, t[0]);
            check_hit(&m, t[0], -d3_dot(normal, m.ray.direction), (double)threshold);
            hits++;
        } else if (m.found) {
            assert_true(least < (double)threshold + slack_of(&m));
            close++;
        } else {
            assert_true(least >= (double)threshold - slack_of(&m) && m.end == MIRROR_PASSED);
            misses++;
        }
    }
    free(values);
    print_message("# ball: %d hits, %d misses, %d that pass within the threshold, %d from inside\n",
                  hits, misses, close, inside);
    assert_true(hits > 5000 && misses > 5000 && inside > 100);
}

TEST(test_march_meets_a_plane_where_it_is)
{
    float *values = rays(PLANE, 1000.0f, 0.01f, 4096.0f, 0.0f);
    int hits = 0;
    for (int i = 0; i < ITEMS; i++) {
        struct marched m = unpack(values, i);
        double sine = -m.ray.direction.y;
        if (!m.unit || m.ray.origin.y < 0.02 || fabs(sine) < 0.005)
            continue;
        check_counts(&m);
        assert_true(m.found == (sine > 0.0));
        if (m.found) {
            check_hit(&m, m.ray.origin.y / sine, sine, 0.01);
            hits++;
        }
    }
    free(values);
    print_message("# plane: %d hits\n", hits);
    assert_true(hits > 3000);
}

TEST(test_empty_interval_is_a_miss_that_costs_nothing)
{
    for (int k = 0; k < 2; k++) {
        float *values = rays(BALL, 5.0f, 0.001f, 512.0f, k == 0 ? 5.0f : 7.0f);
        for (int i = 0; i < ITEMS; i++) {
            struct marched m = unpack(values, i);
            check_counts(&m);
            assert_true(!m.found && m.end == MIRROR_PASSED && m.evaluations == 0);
        }
        free(values);
    }
}

// In a scene that is 1 away from every point, the march takes steps of 1.
TEST(test_march_ends_at_its_limits)
{
    float *values = rays(NOTHING, 7.5f, 0.001f, 512.0f, 0.25f);
    struct marched m = unpack(values, 1);
    check_counts(&m);
    assert_true(m.end == MIRROR_PASSED && m.steps == 8 && m.t == 8.25);
    free(values);
    values = rays(NOTHING, 1000.0f, 0.001f, 5.0f, 0.0f);
    m = unpack(values, 1);
    check_counts(&m);
    assert_true(m.end == MIRROR_GAVE_UP && m.steps == 5 && m.t == 5.0);
    free(values);
    values = rays(BALL, 3.0f, 0.001f, 512.0f, 0.0f);
    for (int i = 0; i < ITEMS; i++) {
        m = unpack(values, i);
        assert_true(m.found ? m.t < 3.0 : m.end != MIRROR_PASSED || m.t >= 3.0);
    }
    free(values);
}

// ---- Bounds ----

TEST(test_box_interval_agrees_with_brute_force)
{
    const struct d3 low = {-0.75, -0.5, -1.25}, high = {0.75, 0.5, 1.25};
    const double m = 1e-5; // a ray that passes closer to an edge may be a hit or a miss
    float *values = rays(INTERVAL, 0.0f, 0.0f, 0.0f, 0.0f);
    int hits = 0, misses = 0, inside = 0, across = 0, edges = 0;
    for (int i = 0; i < ITEMS; i++) {
        const float *v = values + 4 * SLOTS * i;
        struct mirror_ray ray = {d3_of(v), d3_of(v + 4)};
        double t[2], out[2], in[2], entry = (double)v[8], leave = (double)v[9];
        bool wider =
            brute_box_interval(ray, d3_sub(low, d3(m, m, m)), d3_add(high, d3(m, m, m)), out);
        bool closer =
            brute_box_interval(ray, d3_add(low, d3(m, m, m)), d3_sub(high, d3(m, m, m)), in);
        bool hit = brute_box_interval(ray, low, high, t);
        across += ray.direction.x == 0.0 || ray.direction.y == 0.0 || ray.direction.z == 0.0;
        if (wider != closer) {
            edges++;
        } else if (hit) {
            hits++;
            inside += t[0] == 0.0;
            assert_true(fabs(entry - t[0]) < 2e-6 * (1.0 + t[0]) && entry >= 0.0);
            assert_true(fabs(leave - t[1]) < 2e-6 * (1.0 + t[1]));
        } else {
            misses++;
            assert_true(entry > leave);
        }
    }
    free(values);
    print_message(
        "# bounds: %d hits (%d from inside), %d misses, %d with a zero component, %d at an "
        "edge\n",
        hits, inside, misses, across, edges);
    assert_true(hits > 3000 && misses > 3000 && inside > 100 && across > 3000 && edges < 50);
}

// ---- Normal ----

// The normal from central differences of the unit ball in double precision, with the step h.
static struct d3 ball_differences(struct d3 p, double h)
{
    const struct d3 x = {h, 0.0, 0.0}, y = {0.0, h, 0.0}, z = {0.0, 0.0, h};
    return d3_unit(d3(d3_length(d3_add(p, x)) - d3_length(d3_sub(p, x)),
                      d3_length(d3_add(p, y)) - d3_length(d3_sub(p, y)),
                      d3_length(d3_add(p, z)) - d3_length(d3_sub(p, z))));
}

// The largest error of a normal, in degrees. It comes from the rounding errors of the position and
// of the distance, both near 1, divided by the step: about 2 eps / h in radians.
static double worst_normal(int function, float h, bool analytic)
{
    float *values = rays(function, h, 0.0f, 0.0f, 0.0f);
    double worst = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        const float *v = values + 4 * SLOTS * i;
        struct d3 p = d3_of(v + 8), normal = d3_of(v + 12), expected = d3(0.0, 1.0, 0.0);
        if (function == NORMAL_BALL && fabs(d3_length(p) - 1.0) > 1e-6)
            continue;
        if (function == NORMAL_BALL)
            expected = analytic ? p : ball_differences(p, (double)h);
        assert_int_equal((int)v[11], 0);
        assert_int_equal((int)v[15], 6);
        assert_true(fabs(d3_length(normal) - 1.0) < 1e-6);
        worst = fmax(worst, d3_angle(normal, expected));
    }
    free(values);
    return worst;
}

TEST(test_normals_agree_with_the_surface)
{
    const double degrees = 180.0 / MIRROR_PI;
    double fine = worst_normal(NORMAL_BALL, 0.001f, true);
    double coarse = worst_normal(NORMAL_BALL, 0.25f, false);
    double face = worst_normal(NORMAL_BOX, 0.001f, true);
    print_message(
        "# normal: off by at most %.4f degrees on a ball, by %.6f from the same differences "
        "in double precision, by %.4f on a box\n",
        fine, coarse, face);
    assert_true(fine < 3.0 * MIRROR_FLOAT_ROUNDING / 0.001 * degrees);
    assert_true(coarse < 8.0 * MIRROR_FLOAT_ROUNDING / 0.25 * degrees);
    assert_true(face < 3.0 * MIRROR_FLOAT_ROUNDING / 0.001 * degrees);
    // The requested step is used: with 0.25, the truncation error is visible.
    assert_true(worst_normal(NORMAL_BALL, 0.25f, true) > 0.1);
}

// ---- Shadow ----

TEST(test_shadow_ray_finds_what_is_between)
{
    const double look = 4.0;
    float *values = rays(SHADOW, (float)look, 0.001f, 512.0f, 0.25f);
    int free_ones = 0, blocked = 0;
    for (int i = 0; i < ITEMS; i++) {
        const float *v = values + 4 * SLOTS * i;
        struct mirror_ray ray = {d3_of(v + 8), d3_of(v + 12)};
        double t[2];
        assert_true(fabs(ray.origin.y - ((double)v[1] + 0.25)) < 5e-7);
        assert_true(v[8] == v[0] && v[10] == v[2] && v[12] == v[4]);
        double along = fmin(fmax(-d3_dot(ray.origin, ray.direction), 0.0), look);
        double least = d3_length(mirror_at(ray, along)) - 1.0;
        bool crosses = mirror_ball_crossing(ray, 1.0, t) && t[0] < look - 0.1 && t[0] > 0.0;
        if (fabs(d3_length(ray.direction) - 1.0) > 1e-6)
            continue;
        if (crosses && least < -0.01) {
            assert_true(v[11] == 0.0f);
            blocked++;
        } else if (least > 0.01) {
            assert_true(v[11] == 1.0f && v[15] > 0.0f);
            free_ones++;
        }
    }
    free(values);
    print_message("# shadow: %d blocked, %d free\n", blocked, free_ones);
    assert_true(blocked > 3000 && free_ones > 3000);
    values = rays(SHADOW, 0.0f, 0.001f, 512.0f, 0.25f);
    for (int i = 0; i < ITEMS; i++)
        assert_true(values[4 * SLOTS * i + 11] == 1.0f && values[4 * SLOTS * i + 15] == 0.0f);
    free(values);
}

TESTS(gpu_setup, gpu_teardown)
