// occlusion.c - shaders/occlusion.glsl and thickness.glsl: the visible share of the sky compared
// with brute force in double precision, the claims that five taps prove, the errors of the taps,
// reflected light, and paths inside solids.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/occlusion.h"
#include "lib/random.h"

#define SHADER "tests/shaders/occlusion.frag"

enum { BALL, WALL, DIRECTION, RAYS, TAPS, BOUNCES, THICKNESS, THROUGH };
enum { FLOOR_ALONE, BALL_ALONE, BEFORE_WALL, FLOOR_AND_BALL, TWO_BALLS };

// A square grid of 800 x 800 points gives the area of a part of a disc to within about 4e-5.
enum { GRID = 800 };
static const double closed_form = 1e-4;

static const struct d3 up = {0.0, 1.0, 0.0};

// ---- In closed form ----

// The ball is above the horizon, cut by it, or below it.
TEST(a_ball_hides_its_share_of_the_disc)
{
    static const float radii[] = {0.02f, 0.3f, 1.0f, 1.6f, 1.99f};
    double worst = 0.0;
    for (size_t k = 0; k < sizeof radii / sizeof *radii; k++) {
        const float numbers[4] = {radii[k], 2.0f};
        float *values = gpu_call(SHADER, 65, 1, BALL, numbers);
        for (int i = 0; i < 65; i += 3) {
            struct mirror_ball ball = {d3_of(values + 4 * i), (double)radii[k]};
            double truth = 1.0 - occlusion_share(mirror_ball_blocks, &ball, up, GRID);
            worst = fmax(worst, fabs((double)values[4 * i + 3] - truth));
        }
        assert_true((double)values[4 * 64 + 3] == 0.0); // the ball is straight below
        free(values);
    }
    print_message("# ball: worst error %.2g\n", worst);
    assert_true(worst < closed_form);
}

static bool ground_blocks(struct d3 direction, const void *unused)
{
    (void)unused;
    return direction.y < 0.0;
}

TEST(a_slope_sees_half_of_one_plus_its_cosine)
{
    const float numbers[4] = {0.4f};
    float *values = gpu_call(SHADER, 32, 1, WALL, numbers);
    for (int i = 0; i < 32; i += 5) {
        struct d3 normal = d3((double)values[4 * i + 1], (double)values[4 * i + 2], 0.0);
        double truth = occlusion_share(ground_blocks, NULL, d3_unit(normal), GRID);
        assert_true(fabs((double)values[4 * i + 3] - truth) < closed_form);
        struct occlusion_case scene = {OCCLUSION_WALL, 0.4, 0.1 * i};
        double wall = occlusion_brute(&scene, GRID);
        assert_true(i == 0 || fabs((double)values[4 * i] - wall) < closed_form);
    }
    assert_true((double)values[0] == 0.5); // at the foot of the wall
    free(values);
}

TEST(the_closed_forms_of_the_table_are_counted)
{
    for (int thing = 0; thing < OCCLUSION_THINGS; thing++)
        for (int i = 0; i < 6; i++) {
            struct occlusion_case scene = {(enum occlusion_thing)thing, 0.15 + 0.2 * i,
                                           0.58 - 0.1 * i};
            double off = occlusion_truth(&scene) - occlusion_brute(&scene, GRID);
            assert_true(fabs(off) < closed_form);
        }
}

// ---- Rays ----

// The centres of a square's cells become directions. The cells become parts of the disc with equal
// areas, so the density of the directions is proportional to the cosine. Normals along the y axis
// need another axis for the frame around them.
TEST(directions_are_above_the_disc)
{
    static const float normals[][4] = {{0.0f, 1.0f, 0.0f},  {0.48f, 0.6f, -0.64f},
                                       {0.0f, -1.0f, 0.0f}, {1.0f, 0.0f, 0.0f},
                                       {-1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    for (size_t k = 0; k < sizeof normals / sizeof *normals; k++) {
        struct d3 normal = d3_of(normals[k]), sum = d3(0.0, 0.0, 0.0);
        float *values = gpu_call(SHADER, 256, 256, DIRECTION, normals[k]);
        double rise = 0.0;
        for (int i = 0; i < 256 * 256; i++) {
            const float *v = values + 4 * i;
            struct d3 w = d3_of(v);
            double u = (i % 256 + 0.5) / 256.0; // the squared radius of the point on the disc
            assert_true(fabs(d3_length(w) - 1.0) < 1e-5);
            assert_true(fabs((double)v[3] * (double)v[3] - (1.0 - u)) < 1e-5 && v[3] >= 0.0f);
            sum = d3_add(sum, d3_times(1.0 / 65536.0, w));
            rise += (double)v[3] / 65536.0;
        }
        free(values);
        assert_true(fabs(rise - 2.0 / 3.0) < 1e-4); // the mean cosine, the integral of cos^2 / pi
        assert_true(d3_length(d3_sub(sum, d3_times(2.0 / 3.0, normal))) < 1e-4);
    }
}

// The mean over 16,384 pixels, each with different random rays from the same point, is the visible
// share to within three standard errors.
TEST(the_mean_of_the_rays_is_the_visible_share)
{
    enum { SIDE = 128, POINTS = SIDE * SIDE };
    double random = 0.0;
    for (int side = 1; side <= 4; side++) {
        const float numbers[4] = {0.7f, 0.8f, (float)side, FLOOR_AND_BALL};
        float *values = gpu_call(SHADER, SIDE, SIDE, RAYS, numbers);
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < POINTS; i++) {
            sum += (double)values[4 * i];
            squares += (double)values[4 * i] * (double)values[4 * i];
        }
        free(values);
        struct occlusion_case scene = {OCCLUSION_BALL, (double)0.8f, (double)0.7f};
        double mean = sum / POINTS, variance = squares / POINTS - mean * mean;
        double truth = occlusion_truth(&scene), error = sqrt(variance / POINTS);
        print_message(
            "# %d rays: mean %.4f, visible share %.4f; standard deviation of one pixel %.4f\n",
            side * side, mean, truth, sqrt(variance));
        assert_true(fabs(mean - truth) < 3.0 * error + 2e-4);
        random = side == 1 ? variance : random;
        // The variance is less than that of as many independent random rays.
        assert_true(side == 1 || variance < 0.8 * random / (side * side));
    }
}

// ---- Taps ----

static float *taps_of(int scene, float reach, float strength)
{
    const float numbers[4] = {reach, strength, 0.0f, (float)scene};
    return gpu_call(SHADER, 64, 1, TAPS, numbers);
}

TEST(taps_on_an_open_floor_and_on_a_lone_ball_give_1)
{
    static const float reaches[] = {0.1f, 1.0f, 5.0f, 7.3f};
    for (int k = 0; k < 4; k++) {
        float *values = taps_of(FLOOR_ALONE, reaches[k], 1.0f);
        float *round = taps_of(BALL_ALONE, reaches[k], 1.0f);
        for (int i = 0; i < 64; i++) {
            assert_true(values[4 * i + 1] == 1.0f);
            assert_true(fabsf(round[4 * i + 1] - 1.0f) < 1e-5f);
        }
        assert_true(fabsf(values[2] * 16.0f - reaches[k]) < 1e-6f * reaches[k]);
        assert_true(values[3] == reaches[k]);
        free(values);
        free(round);
    }
}

TEST(taps_before_a_wall_are_those_of_double)
{
    static const float strengths[] = {0.5f, 1.0f, 2.0f};
    for (int k = 0; k < 3; k++) {
        float *values = taps_of(BEFORE_WALL, 1.0f, strengths[k]);
        for (int i = 0; i < 64; i++) {
            struct occlusion_case scene = {OCCLUSION_WALL, 0.4, (double)values[4 * i]};
            double quick = occlusion_taps(&scene, 1.0, (double)strengths[k]);
            assert_true(fabs((double)values[4 * i + 1] - quick) < 1e-5);
        }
        free(values);
    }
}

// A tap at height h that finds a distance d < h proves that there is a surface within an angle of
// asin(d / h) of the normal, at a distance from h - d to h + d.
TEST(a_tap_proves_something_near_the_normal)
{
    int proved = 0;
    for (int i = 0; i < 4000; i++) {
        double radius = 0.02 + random_of(i, 1, 0, 0), height = 0.1 + 2.0 * random_of(i, 1, 0, 1);
        struct d3 centre = d3(2.0 * random_of(i, 1, 0, 2) - 1.0, 2.0 * random_of(i, 1, 0, 3),
                              2.0 * random_of(i, 1, 0, 4) - 1.0);
        struct d3 tap = d3_times(height, up), from = d3_sub(centre, tap);
        double d = d3_length(from) - radius;
        if (d3_length(centre) < radius || d <= 0.0 || d >= height)
            continue;
        struct d3 nearest = d3_add(tap, d3_times(d / d3_length(from), from));
        double far = d3_length(nearest), angle = atan2(hypot(nearest.x, nearest.z), nearest.y);
        assert_true(angle <= asin(d / height) + 1e-9);
        assert_true(far >= height - d - 1e-9 && far <= height + d + 1e-9);
        proved++;
    }
    assert_true(proved > 500);
}

// An obstacle up to a distance of `reach`: a ball, or, if hollow, everything outside the ball.
struct near_ball {
    struct d3 centre;
    double radius, reach;
    bool hollow;
};

static bool near_ball_blocks(struct d3 w, const void *data)
{
    const struct near_ball *near = data;
    double along = d3_dot(near->centre, w);
    double square = d3_dot(near->centre, near->centre) - along * along;
    double half = sqrt(fmax(near->radius * near->radius - square, 0.0));
    double t = near->hollow ? along + half : along - half;
    return half > 0.0 && t > 0.0 && t < near->reach;
}

// If a tap finds a distance of its whole height h, at least the share 1 - (r / (2 h))^2 of the
// directions is free up to the distance r, whatever ball touches the tap's empty ball from outside.
// If everything except the tap's ball is solid, exactly this share is free.
TEST(a_whole_tap_proves_a_share_free)
{
    const double coarse = 2e-3; // the error of 200 x 200 points
    double least = 1.0;
    for (int i = 0; i < 200; i++) {
        double height = 0.2 + random_of(i, 2, 0, 0), r = 2.0 * height * random_of(i, 2, 0, 1);
        double share = 1.0 - r * r / (4.0 * height * height);
        struct near_ball hollow = {d3_times(height, up), height, r, true};
        assert_true(fabs(occlusion_share(near_ball_blocks, &hollow, up, 200) - share) < coarse);
        double turn = 6.28 * random_of(i, 2, 0, 2), side = 2.0 * random_of(i, 2, 0, 3) - 1.0;
        double wide = sqrt(1.0 - side * side), radius = 0.1 + 3.0 * random_of(i, 2, 0, 4);
        struct d3 way = d3(wide * cos(turn), side, wide * sin(turn));
        struct d3 centre = d3_add(d3_times(height, up), d3_times(height + radius, way));
        struct near_ball outside = {centre, radius, r, false};
        double seen = occlusion_share(near_ball_blocks, &outside, up, 200);
        assert_true(seen > share - coarse);
        least = fmin(least, seen);
    }
    assert_true(least < 0.9); // some of the balls hide much of the sky
}

TEST(two_points_with_the_same_taps_see_half_and_nothing)
{
    struct occlusion_case wall = {OCCLUSION_WALL, 40.0, 0.1};
    struct occlusion_case shaft = {OCCLUSION_SHAFT, 40.0, 0.1};
    for (int k = 0; k < 40; k++)
        assert_true(occlusion_distance(&wall, 0.1 * k) == occlusion_distance(&shaft, 0.1 * k));
    assert_true(occlusion_brute(&wall, GRID) > 0.5 && occlusion_brute(&shaft, GRID) < 1e-4);
}

// The errors in the table of docs/14_occlusion.md, which build/tests/measure occlusion prints.
TEST(taps_err_as_the_page_says)
{
    for (int thing = 0; thing <= OCCLUSION_BALL; thing++) {
        struct occlusion_error none = occlusion_error_of((enum occlusion_thing)thing, 0.0);
        struct occlusion_error taps = occlusion_error_of((enum occlusion_thing)thing, 1.0);
        if (thing == OCCLUSION_NOTHING)
            assert_true(taps.worst == 0.0);
        else if (thing == OCCLUSION_BAR) // too dark, and farther from the truth than without taps
            assert_true(taps.mean < -0.04 && taps.mean_size > none.mean_size);
        else
            assert_true(taps.mean_size < 0.6 * none.mean_size);
    }
    struct occlusion_error none = occlusion_scene_error(0), taps = occlusion_scene_error(2);
    struct occlusion_error steps = occlusion_scene_error(4);
    assert_true(taps.mean_size < 0.5 * none.mean_size);
    assert_true(steps.mean_size > none.mean_size);
}

// ---- Reflected light ----

TEST(a_white_furnace_stays_white)
{
    for (int bounces = 0; bounces <= 2; bounces++) {
        const float numbers[4] = {1.0f, 0.5f, 0.0f, (float)bounces};
        float *values = gpu_call(SHADER, 256, 1, BOUNCES, numbers);
        // If no point sees the sky, the quotient would be 0 / 0, but the result is 0.
        assert_true(values[0] == 0.0f);
        for (int i = 1; i < 256; i++) {
            const float *v = values + 4 * i;
            double open = (double)v[3], back = 1.0 - open, sum = 0.0, power = 1.0;
            for (int k = 0; k <= (bounces == 2 ? 20000 : bounces); k++) {
                sum += open * power;
                power *= back;
            }
            assert_true(fabs((double)v[0] - sum) < 1e-4);
            assert_true(bounces < 2 || fabs((double)v[0] - 1.0) < 1e-4);
            assert_true(fabs((double)v[2] - open) < 1e-6); // a black surface reflects nothing
        }
        free(values);
    }
}

// A point on a hollow ball of radius 1 around the origin. The part of the ball above y = height is
// missing.
struct hollow {
    struct d3 position;
    double height;
};

static bool hollow_blocks(struct d3 w, const void *data)
{
    const struct hollow *hollow = data;
    return hollow->position.y - 2.0 * d3_dot(hollow->position, w) * w.y < hollow->height;
}

// Every point of the ball sees the same share of the sky: the share of the ball's surface that the
// hole takes up. All points therefore receive the same light, and after any number of reflections
// the light is exactly that of skyAndBounces.
TEST(in_a_hollow_ball_all_points_are_alike)
{
    double height = 0.3, hole = 0.5 * (1.0 - height);
    for (int i = 0; i < 6; i++) {
        double y = -1.0 + 1.25 * i / 5.0, turn = 1.0 + i;
        double wide = sqrt(fmax(1.0 - y * y, 0.0));
        struct hollow hollow = {d3(wide * cos(turn), y, wide * sin(turn)), height};
        struct d3 inwards = d3_times(-1.0, hollow.position);
        double share = occlusion_share(hollow_blocks, &hollow, inwards, GRID);
        assert_true(fabs(share - hole) < 3.0 * closed_form);
    }
}

// ---- Paths inside ----

static double chord(const float *v, double x, double z, double centre)
{
    struct mirror_ray ray = {d3(x - centre, 0.0, z), d3((double)v[0], 0.0, (double)v[1])};
    double t[2];
    return mirror_ball_crossing(ray, 1.0, t) ? t[1] : 0.0;
}

TEST(a_path_through_a_ball_is_its_chord)
{
    const float numbers[4] = {-0.9f, 0.2f, 9.0f, BALL_ALONE};
    float *values = gpu_call(SHADER, 126, 1, THICKNESS, numbers);
    for (int i = 0; i < 126; i++)
        assert_true(fabs((double)values[4 * i + 2] -
                         chord(values + 4 * i, (double)-0.9f, (double)0.2f, 0.0)) < 1e-3);
    free(values);
    const float near[4] = {-0.9f, 0.2f, 0.5f, BALL_ALONE}; // the path ends at the lamp
    values = gpu_call(SHADER, 1, 1, THICKNESS, near);
    assert_true(values[2] == 0.5f);
    free(values);
}

// Inside the union, the distance is only a lower bound of the depth, but the length of the path is
// right.
TEST(a_path_through_a_union_does_not_end_between_its_parts)
{
    const float numbers[4] = {-1.5f, 0.1f, 9.0f, TWO_BALLS};
    float *values = gpu_call(SHADER, 126, 1, THICKNESS, numbers);
    int both = 0;
    for (int i = 0; i < 126; i++) {
        const float *v = values + 4 * i;
        double first = chord(v, (double)-1.5f, (double)0.1f, -0.6);
        struct d3 out =
            d3((double)-1.5f + first * (double)v[0], 0.0, (double)0.1f + first * (double)v[1]);
        bool on = hypot(out.x - 0.6, out.z) < 1.0;
        double way = on ? chord(v, (double)-1.5f, (double)0.1f, 0.6) : first;
        assert_true(fabs((double)v[2] - way) < 2e-3);
        both += on;
    }
    free(values);
    assert_true(both > 10);
}

TEST(light_falls_by_the_same_share_for_each_length)
{
    const float numbers[4] = {0.42f, 0.2f, 0.085f};
    float *values = gpu_call(SHADER, 200, 1, THROUGH, numbers);
    for (int i = 0; i < 200; i++)
        for (int k = 0; k < 3; k++) {
            double left = exp(-(double)values[4 * i + 3] / (double)numbers[k]);
            assert_true(fabs((double)values[4 * i + k] - left) < 1e-5);
        }
    free(values);
}

TESTS(gpu_setup, gpu_teardown)
