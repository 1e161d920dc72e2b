// glass.c - shaders/glass.glsl, fresnel.glsl and caustic.glsl: the light that a surface reflects
// and refracts, rays through a ball compared with their analytical path, the light that a straight
// ray loses, the light behind a ball, the depth inside solids, and a white furnace.
#include "lib/test.h"
#include "lib/glass.h"
#include "lib/gpu.h"
#include "lib/random.h"

#define SHADER "tests/shaders/glass.frag"

enum {
    FRESNEL,
    BALL = 2,
    STRAIGHT,
    CAUSTIC,
    COLOUR,
    PRISM,
    ABSORBED,
    WAVES,
    DEPTH,
    BEAM,
    INSIDE,
    FOOT
};

// ---- A surface ----

TEST(the_reflected_share_is_that_of_fresnel)
{
    static const float etas[] = {1.0f / 1.333f, 1.0f / 1.5168f, 1.0f / 1.7283f,
                                 1.333f,        1.5168f,        2.4f};
    double worst = 0.0;
    for (size_t k = 0; k < sizeof etas / sizeof *etas; k++) {
        const float numbers[4] = {etas[k]};
        float *values = gpu_call(SHADER, 513, 1, FRESNEL, numbers);
        for (int i = 0; i < 513; i++)
            worst = fmax(worst, fabs((double)values[4 * i + 1] -
                                     glass_fresnel((double)values[4 * i], (double)etas[k])));
        free(values);
    }
    print_message("# Fresnel: worst error %.2g\n", worst);
    assert_true(worst < 2e-4); // near the critical angle, the slope of the share is infinite
}

// The share of the light that passes through a surface is the same in both directions along a ray.
TEST(both_sides_reflect_the_same_share)
{
    for (double c = 0.02; c < 1.0; c += 0.02) {
        double behind = sqrt(1.0 - (1.0 - c * c) / (1.5 * 1.5));
        assert_true(fabs(glass_fresnel(c, 1.0 / 1.5) - glass_fresnel(behind, 1.5)) < 1e-12);
    }
}

// The errors that the header of schlickShare in fresnel.glsl states.
TEST(schlick_is_off_by_the_stated_error)
{
    static const double cases[][2] = {{1.333, 0.060}, {1.5, 0.036}};
    for (int k = 0; k < 2; k++) {
        double n = cases[k][0], worst = 0.0, straight = pow((n - 1.0) / (n + 1.0), 2.0);
        for (double c = 0.0; c <= 1.0; c += 1e-3)
            worst = fmax(worst, fabs(glass_schlick(c, straight) - glass_fresnel(c, 1.0 / n)));
        assert_true(worst < cases[k][1] && worst > 0.95 * cases[k][1]);
    }
}

// ---- Through a ball ----

static double ball(struct d3 p)
{
    return d3_length(p) - 1.0;
}

struct through {
    double inside; // length of the path inside the ball
    struct d3 left;
    bool done;
};

// The path of a ray that meets the ball at the distance `offset` from the z axis and leaves the
// ball again, marched in double precision.
static struct through ball_marched(double offset, double turn, double index, double threshold,
                                   double start)
{
    struct mirror_ray ray = {d3(offset * cos(turn), offset * sin(turn), 3.0), d3(0.0, 0.0, -1.0)};
    const double outside[2] = {0.0, 9.0};
    struct through way = {0.0, d3(0.0, 0.0, 0.0), false};
    double t;
    struct d3 bent;
    if (!glass_march(ball, ray, 1.0, outside, threshold, 4096, &t))
        return way;
    struct d3 p = mirror_at(ray, t), n = d3_unit(p);
    if (!glass_refract(ray.direction, n, 1.0 / index, &bent))
        return way;
    ray = glass_leaving(p, n, bent, start);
    if (!glass_march(ball, ray, -1.0, outside, threshold, 4096, &way.inside))
        return way;
    n = d3_unit(mirror_at(ray, way.inside));
    way.done = glass_refract(ray.direction, d3_times(-1.0, n), index, &way.left);
    return way;
}

// The larger of two errors: of the direction, and of the length of the path inside the ball. On the
// analytical path, with the angles of incidence i and of refraction j, the ray is deflected by
// 2 (i - j) towards the axis, and its path inside the ball is 2 cos(j) long.
static double ball_error(struct through way, double offset, double turn, double index)
{
    double i = asin(offset), j = asin(offset / index), bend = 2.0 * (i - j);
    struct d3 left = d3(-sin(bend) * cos(turn), -sin(bend) * sin(turn), -cos(bend));
    return fmax(d3_length(d3_sub(way.left, left)), fabs(way.inside - 2.0 * cos(j)));
}

TEST(ten_thousand_rays_follow_the_analytical_path_through_a_ball)
{
    const double threshold = 1e-9, index = 1.5168;
    double worst = 0.0;
    for (int i = 0; i < 10000; i++) {
        double offset = 0.9999 * sqrt(random_of(i, 0, 0, 0)), turn = 6.0 * random_of(i, 1, 0, 0);
        struct through way = ball_marched(offset, turn, index, threshold, 2.5 * threshold);
        assert_true(way.done);
        worst = fmax(worst, ball_error(way, offset, turn, index));
    }
    print_message("# 10,000 rays: worst error %.2g\n", worst);
    assert_true(worst < 1e-6);
}

// If the start is half a threshold off the surface, every march inside ends where it starts; if it
// is 2.5 thresholds off, none does.
TEST(a_march_that_starts_too_near_is_stranded)
{
    const double threshold = 1e-4;
    int stranded[2] = {0, 0};
    for (int i = 0; i < 1000; i++)
        for (int k = 0; k < 2; k++) {
            struct through way =
                ball_marched(0.001 * i, 0.0, 1.5168, threshold, (k == 0 ? 0.5 : 2.5) * threshold);
            stranded[k] += way.inside < 10.0 * threshold;
        }
    assert_true(stranded[0] == 1000 && stranded[1] == 0);
}

static double half_space(struct d3 p)
{
    return p.y;
}

// Above a flat face, each step multiplies the height by 1 + sin(angle), so a ray that leaves at a
// small angle runs out of steps.
TEST(a_ray_that_leaves_at_a_small_angle_runs_out_of_steps)
{
    const double threshold = 0.0004, start = 2.5 * threshold, to_height_1[2] = {0.0, 1e9};
    for (int i = 1; i < 40; i++) {
        double angle = 0.25 * i * MIRROR_PI / 180.0, t;
        struct mirror_ray ray = {d3(0.0, start, 0.0), d3(cos(angle), sin(angle), 0.0)};
        glass_march(half_space, ray, 1.0, to_height_1, threshold, 80, &t);
        double height = start + t * sin(angle);
        assert_true(fabs(height / (start * pow(1.0 + sin(angle), 80.0)) - 1.0) < 1e-9);
        assert_true((height > 1.0) ==
                    (sin(angle) > pow(1.0 / start, 1.0 / 80.0) - 1.0)); // angle > 5.2 degrees
    }
}

TEST(the_library_follows_the_same_path)
{
    const float numbers[4] = {1.5168f, 0.0001f, 2.5f};
    float *values = gpu_call(SHADER, 500, 16, BALL, numbers);
    double worst = 0.0;
    for (int i = 0; i < 500 * 16; i++) {
        double offset = (i % 500 + 0.5) / 512.0, turn = 0.4 * (i / 500);
        struct through way = {(double)values[4 * i + 3], d3_of(values + 4 * i), true};
        assert_true(way.inside > 0.0);
        worst = fmax(worst, ball_error(way, offset, turn, (double)numbers[0]));
    }
    free(values);
    print_message("# through the ball with the library: worst error %.2g\n", worst);
    assert_true(worst < 0.02); // at the rim, the error is the threshold divided by the cosine
}

// Rays march from the middle of a slab to its face, at increasing angles. The first ray that cannot
// leave is at asin(1 / n).
TEST(nothing_gets_out_beyond_the_critical_angle)
{
    static const float indices[] = {1.333f, 1.5168f, 1.7283f};
    for (size_t k = 0; k < sizeof indices / sizeof *indices; k++) {
        double critical = asin(1.0 / (double)indices[k]) * 180.0 / MIRROR_PI, first = 0.0;
        const float numbers[4] = {indices[k], 30.0f};
        float *values = gpu_call(SHADER, 2000, 1, INSIDE, numbers);
        for (int i = 0; i < 2000; i++) {
            double angle = (double)values[4 * i], way = 0.5 / cos(angle * MIRROR_PI / 180.0);
            assert_true(fabs((double)values[4 * i + 3] - way) < 0.001);
            bool total = values[4 * i + 1] == 0.0f;
            assert_true(total == (values[4 * i + 2] == 1.0f));
            first = total && first == 0.0 ? angle : first;
        }
        free(values);
        print_message("# index %.4f: total reflection from %.2f degrees on (formula: %.2f)\n",
                      (double)indices[k], first, critical);
        assert_true(fabs(first - critical) < 0.02);
    }
}

// ---- What is left of the light ----

TEST(shares_of_paths_inside_multiply)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 256, 1, ABSORBED, none);
    const double absorption[3] = {0.2, 1.0, 3.0};
    for (int i = 0; i < 256; i++)
        for (int c = 0; c < 3; c++)
            assert_true(fabs((double)values[4 * i + c] - exp(-absorption[c] * (0.01 * i + 0.5))) <
                        1e-5);
    free(values);
}

TEST(a_straight_ray_meets_both_surfaces)
{
    double share = 0.0, inside = 0.0;
    for (int shape = 0; shape < 2; shape++) {
        const float numbers[4] = {(float)shape, 1.5f, 0.004f};
        float *values = gpu_call(SHADER, 250, 1, STRAIGHT, numbers);
        for (int i = 0; i < 250; i++) {
            const float *v = values + 4 * i;
            double c = shape == 1 ? cos((double)v[3]) : sqrt(1.0 - (double)v[3] * (double)v[3]);
            double way = shape == 1 ? 1.0 / c : 2.0 * c, passes = 1.0 - glass_fresnel(c, 1.0 / 1.5);
            inside = fmax(inside, fabs((double)v[1] - way));
            share = fmax(share, c > 0.3 ? fabs((double)v[0] - passes * passes) : 0.0);
        }
        free(values);
    }
    print_message("# straight ray: share off by at most %.2g, path by at most %.2g\n", share,
                  inside);
    assert_true(share < 0.003 && inside < 0.01);
}

// ---- The light behind a ball ----

// Every plane behind the ball receives all the light that enters within 0.96 radii of the axis,
// minus the reflected part. The light that enters farther out is the share that the header of
// caustic.glsl states.
TEST(no_light_is_lost_behind_a_ball)
{
    static const float cases[][2] = {
        {1.05f, 0.02f}, {1.3f, 0.02f}, {2.0f, 0.02f}, {1.45f, 0.2f}}; // plane, blur
    double truth = 0.0, whole = 0.0;
    for (int i = 0; i < 4000; i++) {
        double b = (i + 0.5) / 4000.0,
               passes = 1.0 - glass_fresnel(sqrt(1.0 - b * b), 1.0 / 1.5168);
        whole += 2.0 * b / 4000.0 * passes * passes;
        truth += b < 0.96 ? 2.0 * b / 4000.0 * passes * passes : 0.0;
    }
    assert_true(fabs(1.0 - truth / whole - 0.037) < 0.0005);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const float numbers[4] = {1.5168f, cases[k][0], cases[k][1]};
        float *values = gpu_call(SHADER, 2048, 1, CAUSTIC, numbers);
        double sum = 0.0;
        for (int i = 0; i < 2048; i++)
            sum += 2.0 * (double)values[4 * i] * (double)values[4 * i + 1] * 3.0 / 2048.0;
        free(values);
        print_message("# z = %.2f: %.4f of %.4f\n", (double)cases[k][0], sum, truth);
        assert_true(fabs(sum - truth) < 0.005 * truth);
    }
}

// No light arrives at planes up to 0.9 radii behind the ball's centre, because every ray leaves the
// ball at least 0.98 radii behind the centre.
TEST(no_light_arrives_before_it_has_left_the_ball)
{
    for (int k = 1; k < 10; k++) {
        const float numbers[4] = {1.5168f, 0.1f * (float)k, 0.02f};
        float *values = gpu_call(SHADER, 2048, 1, CAUSTIC, numbers);
        for (int i = 0; i < 2048; i++)
            assert_true(values[4 * i + 1] == 0.0f);
        free(values);
    }
}

// The expected light comes from rays that enter at the distance b from the axis, are traced one by
// one, and are counted in rings of their distance r from the axis behind the ball. ballCaustic
// spreads the light of each ring of b evenly, so the two agree only roughly.
TEST(the_light_behind_a_ball_is_that_of_many_rays)
{
    enum { RINGS = 12, RAYS = 200000 };
    const float numbers[4] = {1.5168f, 1.2f, 0.02f};
    float *values = gpu_call(SHADER, 2048, 1, CAUSTIC, numbers);
    double light[RINGS] = {0.0}, seen[RINGS] = {0.0};
    for (int i = 0; i < RAYS; i++) {
        double b = 0.96 * (i + 0.5) / RAYS, j = asin(b / 1.5168), turn = 2.0 * (asin(b) - j);
        double passes = 1.0 - glass_fresnel(sqrt(1.0 - b * b), 1.0 / 1.5168);
        // The ray leaves the ball at (y, z), and meets the plane z = 1.2 at the distance r from the
        // axis.
        double angle = asin(b) - turn, y = sin(angle), z = cos(angle);
        double r = fabs(y - (1.2 - z) * tan(turn));
        int ring = (int)(r / 0.075);
        if (ring < RINGS)
            light[ring] += 2.0 * b * 0.96 / RAYS * passes * passes;
    }
    for (int i = 0; i < 2048; i++) {
        int ring = (int)((double)values[4 * i] / 0.075);
        if (ring < RINGS)
            seen[ring] += 2.0 * (double)values[4 * i] * (double)values[4 * i + 1] * 3.0 / 2048.0;
    }
    free(values);
    for (int k = 0; k < RINGS; k++) {
        print_message("# ring %d: %.4f of %.4f\n", k, seen[k], light[k]);
        assert_true(fabs(seen[k] - light[k]) < 0.02);
    }
}

// ---- Depths ----

// If the distances at two points never differ by more than the distance between the points, then no
// part of the surface is nearer than a shape's distance claims, inside or outside. The test
// compares 4096 points with 2341 points.
TEST(the_distance_to_the_tumbler_bounds_the_depth)
{
    const float numbers[4] = {2.0f};
    float *values = gpu_call(SHADER, 64, 64, DEPTH, numbers);
    static float cloud[128 * 128 * 4];
    float *others = gpu_call(SHADER, 128, 128, DEPTH, numbers);
    int inside = 0;
    for (int i = 0; i < 128 * 128 * 4; i++)
        cloud[i] = others[i];
    free(others);
    for (int i = 0; i < 64 * 64; i++) {
        inside += values[4 * i + 3] < 0.0f;
        for (int k = 0; k < 128 * 128; k += 7) {
            double way = d3_length(d3_sub(d3_of(values + 4 * i), d3_of(cloud + 4 * k)));
            assert_true(fabs((double)(values[4 * i + 3] - cloud[4 * k + 3])) <= way + 1e-5);
        }
    }
    free(values);
    assert_true(inside > 300);
}

// The true depth is not more than the claimed one: the point at the claimed distance from a point
// inside, along the slope, is on the surface. Where the length of the slope is not 1, two parts of
// the surface are equally near; these points are left out.
TEST(the_depth_is_exact_inside)
{
    static const float shapes[] = {0.0f, 1.0f, 2.0f, 4.0f};
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++) {
        const float numbers[4] = {shapes[k]};
        float *values = gpu_call(SHADER, 64, 64, FOOT, numbers);
        int inside = 0;
        double worst = 0.0;
        for (int i = 0; i < 64 * 64; i++) {
            const float *v = values + 4 * i;
            if (v[0] >= 0.0f || fabs((double)v[2] - 1.0) > 1e-3)
                continue;
            inside++;
            worst = fmax(worst, fabs((double)v[1]));
        }
        free(values);
        print_message("# shape %g: %d points inside, worst error %.2g\n", (double)shapes[k], inside,
                      worst);
        assert_true(inside > 200 && worst < 2e-3);
    }
}

// The distance of a block made of two touching halves claims that there is a surface between them.
TEST(a_union_has_a_wall_where_its_parts_touch)
{
    const float numbers[4] = {3.0f};
    float *values = gpu_call(SHADER, 64, 64, DEPTH, numbers);
    double worst = 0.0;
    for (int i = 0; i < 64 * 64; i++) {
        struct d3 p = d3_of(values + 4 * i);
        double depth = -mirror_box(p, d3(1.0, 0.5, 0.5)), claimed = -(double)values[4 * i + 3];
        if (depth <= 0.0)
            continue;
        assert_true(claimed <= depth + 1e-6); // the claim is still a lower bound
        worst = fmax(worst, depth - claimed);
    }
    free(values);
    assert_true(worst > 0.4);
}

// ---- The white furnace ----

TEST(clear_glass_in_a_white_world_is_white)
{
    struct glass_rest before = {1.0, 1.0}, rest;
    for (int surfaces = 4; surfaces <= 20; surfaces += 4) {
        rest = glass_furnace(surfaces);
        assert_true(rest.mean < before.mean);
        before = rest;
    }
    assert_true(rest.mean < 0.015 &&
                rest.pixels < 0.02); // some rays are reflected again and again near an edge
}

TESTS(gpu_setup, gpu_teardown)
