// cone.c - shaders/cone.glsl along random rays on the GPU, compared with the same marches in double
// precision. The interval of a tetrahedron is compared with the points inside it.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define SHADER "tests/shaders/symmetry.frag"
#define FAR    12.0

enum { RAYS = 20, ITEMS_WIDE = 256, SLOTS = 4, ROWS = 32, ITEMS = ITEMS_WIDE * ROWS };
enum { BALL, PLANE, PYRAMID };

// The shader's results for one ray.
struct ray_result {
    struct mirror_ray ray;
    double spread_of_pixel, march_t;
    double t;
    bool found;
    int steps, first_steps; // steps of marchCone, and of march on the same ray
    double entry, leave, share;
    int marches;
};

static float *call(int scene, float threshold, float spread, float most_steps)
{
    return gpu_call(SHADER, ITEMS_WIDE * SLOTS, ROWS, RAYS,
                    (const float[4]){(float)scene, threshold, spread, most_steps});
}

static struct ray_result result_of(const float *values, int item)
{
    const float *v = values + (size_t)4 * SLOTS * (size_t)item;
    return (struct ray_result){.ray = {d3_of(v), d3_of(v + 4)},
                               .spread_of_pixel = (double)v[3],
                               .march_t = (double)v[7],
                               .t = (double)v[8],
                               .found = v[9] != 0.0f,
                               .steps = (int)v[10],
                               .first_steps = (int)v[11],
                               .entry = (double)v[12],
                               .leave = (double)v[13],
                               .share = (double)v[14],
                               .marches = (int)v[15]};
}

static double distance_of(int scene, struct d3 p)
{
    return scene == BALL ? mirror_sphere(p, 1.0) : p.y;
}

// ---- marchCone ----

TEST(test_march_cone_without_spread_is_march)
{
    for (int scene = BALL; scene <= PYRAMID; scene++) {
        float *values = call(scene, 0.001f, 0.0f, 200.0f);
        int found = 0;
        for (int i = 0; i < ITEMS; i++) {
            struct ray_result r = result_of(values, i);
            assert_true(r.t == r.march_t && r.steps == r.first_steps && r.marches == 3);
            found += r.found;
        }
        free(values);
        assert_true(found > ITEMS / 10 && found < ITEMS);
    }
}

struct state {
    double t;
    int steps;
    bool found;
    double nearest_call; // the smallest |distance - threshold - spread t| of all steps
};

static struct state march_in_cone(int scene, struct mirror_ray ray, double threshold, double spread)
{
    struct state state = {.nearest_call = HUGE_VAL};
    while (state.t < FAR && state.steps < 200 && !state.found) {
        double distance = distance_of(scene, mirror_at(ray, state.t));
        double over = distance - threshold - spread * state.t;
        state.steps++;
        state.nearest_call = fmin(state.nearest_call, fabs(over));
        state.found = over < 0.0;
        state.t += state.found ? 0.0 : distance;
    }
    return state;
}

static void check_cone(int scene, float threshold, float spread)
{
    float *values = call(scene, threshold, spread, 200.0f);
    int decided = 0, hits = 0;
    double worst = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        struct ray_result r = result_of(values, i);
        struct state state = march_in_cone(scene, r.ray, (double)threshold, (double)spread);
        if (state.nearest_call < 1e-5 || fabs(state.t - FAR) < 1e-4)
            continue; // rounding could change the result
        decided++;
        hits += state.found;
        assert_true(r.found == state.found && r.steps == state.steps);
        worst = fmax(worst, fabs(r.t - state.t));
    }
    free(values);
    print_message(
        "# scene %d, threshold %g, spread %g: %d rays compared, %d hits, t off by at most "
        "%.1g\n",
        scene, (double)threshold, (double)spread, decided, hits, worst);
    assert_true(decided > ITEMS * 9 / 10 && hits > ITEMS / 10 && worst < 0.001);
}

TEST(test_march_cone_stops_where_the_footprint_begins)
{
    for (int scene = BALL; scene <= PLANE; scene++) {
        check_cone(scene, 0.001f, 0.01f);
        check_cone(scene, 0.01f, 0.0f);
        check_cone(scene, 0.0001f, 0.0625f);
    }
}

TEST(test_march_cone_runs_out_of_steps)
{
    float *values = call(BALL, 0.0001f, 0.0001f, 5.0f);
    int given_up = 0;
    for (int i = 0; i < ITEMS; i++) {
        struct ray_result r = result_of(values, i);
        assert_true(r.steps <= 5);
        given_up += !r.found && r.t < FAR;
    }
    free(values);
    assert_true(given_up > ITEMS / 10);
}

// The picture is 32 pixels high, and the focal lengths are 1, 2 and 4.
TEST(test_a_pixel_spreads_as_the_screen_says)
{
    for (int k = 0; k < 3; k++) {
        gpu.renderer.focal_length = (float)(1 << k);
        float *values = call(BALL, 0.001f, 0.0f, 1.0f);
        double spread = result_of(values, 77).spread_of_pixel;
        free(values);
        // The screen has a half height of 1, and is focal_length away from the eye.
        double half_pixel = 0.5 * (mirror_screen_y(18.0, ROWS) - mirror_screen_y(17.0, ROWS));
        assert_true(fabs(spread * (1 << k) / half_pixel - 1.0) < 1e-6);
    }
    gpu.renderer.focal_length = 1.0f;
}

// ---- coneReaching ----

// coneReaching in double precision.
static double share_in_cone(int scene, struct mirror_ray ray, double threshold, double spread)
{
    double t = 0.0, smallest = 1.0;
    for (int steps = 0; steps < 200 && t < FAR && smallest > 0.2; steps++) {
        double distance = distance_of(scene, mirror_at(ray, t));
        smallest = fmin(smallest, distance / (threshold + spread * t));
        t += distance;
    }
    return fmax((smallest - 0.2) / 0.8, 0.0);
}

// The smallest distance from the ray to the ball's centre, minus the radius; it is negative if the
// ray meets the ball.
static double clearance(struct mirror_ray ray)
{
    double nearest = fmax(-d3_dot(ray.origin, ray.direction), 0.0);
    return d3_length(mirror_at(ray, nearest)) - 1.0;
}

TEST(test_cone_reaching_gives_the_share_of_the_light)
{
    const double threshold = 0.01, spread = 0.03;
    float *values = call(BALL, (float)threshold, (float)spread, 200.0f);
    int free_rays = 0, blocked = 0, grey = 0;
    double worst = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        struct ray_result r = result_of(values, i);
        double expected =
            share_in_cone(BALL, r.ray, (double)(float)threshold, (double)(float)spread);
        double clear = clearance(r.ray);
        worst = fmax(worst, fabs(r.share - expected));
        if (clear > threshold + spread * FAR)
            assert_true(r.share == 1.0);
        if (clear < 0.0)
            assert_true(r.share == 0.0);
        free_rays += r.share == 1.0;
        blocked += r.share == 0.0;
        grey += r.share > 0.0 && r.share < 1.0;
    }
    free(values);
    print_message("# %d rays free, %d blocked, %d in between; share off by at most %.1g\n",
                  free_rays, blocked, grey, worst);
    assert_true(free_rays > 100 && blocked > 100 && grey > 100 && worst < 0.002);
}

// ---- tetrahedronInterval ----

static bool is_inside(struct d3 p)
{
    return p.x + p.y - p.z < 0.75 && p.x - p.y + p.z < 0.75 && -p.x + p.y + p.z < 0.75 &&
           -p.x - p.y - p.z < 0.75;
}

// A point of a ray is inside the tetrahedron if, and only if, it is between the entry and the exit.
TEST(test_interval_contains_the_points_inside)
{
    float *values = call(BALL, 0.001f, 0.0f, 1.0f);
    int hits = 0;
    for (int i = 0; i < ITEMS; i++) {
        struct ray_result r = result_of(values, i);
        hits += r.entry < r.leave;
        for (int k = 0; k < 200; k++) {
            double t = FAR * (k + 0.5) / 200.0;
            bool claimed = t > r.entry && t < r.leave;
            if (fabs(t - r.entry) > 1e-4 && fabs(t - r.leave) > 1e-4)
                assert_true(claimed == is_inside(mirror_at(r.ray, t)));
        }
    }
    free(values);
    assert_true(hits > ITEMS / 10 && hits < ITEMS - ITEMS / 10);
}

TESTS(gpu_setup, gpu_teardown)
