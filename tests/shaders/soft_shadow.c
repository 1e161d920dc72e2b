// soft_shadow.c - shaders/soft_shadow.glsl: the visible share of a lamp of finite size compared
// with brute force in double precision, the bounds from one march, and the mean of many rays.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/random.h"
#include "lib/shadow.h"

#define SHADER "tests/shaders/soft_shadow.frag"

enum { EDGE, DISC, BALL, EDGE_IN_SPACE, POINT, DIRECTION, RAYS, CLEARANCE };

// A square grid of 800 x 800 points gives the area of a part of a disc to within about 4e-5.
enum { GRID = 800 };
static const double closed_form = 1e-4;

// A direction that is not parallel to any line of the grid.
#define SLANT_X 0.5403023058681398
#define SLANT_Y 0.8414709848078965

static const struct d3 to_light = {0.48, 0.6, -0.64};

// ---- Discs in a plane ----

// The share of the unit disc on which a test is true, found by counting points of a grid.
static double part_of_disc(bool (*holds)(double x, double y, const double *data),
                           const double *data)
{
    long all = 0, part = 0;
    for (int i = 0; i < GRID * GRID; i++) {
        double x = (2.0 * (i % GRID) + 1.0) / GRID - 1.0, y = (2.0 * (i / GRID) + 1.0) / GRID - 1.0;
        if (x * x + y * y > 1.0)
            continue;
        all++;
        part += holds(x, y, data);
    }
    return (double)part / (double)all;
}

static bool beside_edge(double x, double y, const double *clear)
{
    return SLANT_X * x + SLANT_Y * y < *clear;
}

static bool beside_disc(double x, double y, const double *disc)
{
    double a = x - SLANT_X * disc[0], b = y - SLANT_Y * disc[0];
    return a * a + b * b > disc[1] * disc[1];
}

TEST(a_straight_edge_leaves_a_segment)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 1281, 1, EDGE, none);
    double worst = 0.0;
    for (int i = 0; i < 1281; i += 80) {
        double clear = (double)values[4 * i];
        worst = fmax(worst, fabs((double)values[4 * i + 1] - part_of_disc(beside_edge, &clear)));
    }
    assert_true((double)values[1] == 0.0 && (double)values[4 * 1280 + 1] == 1.0);
    assert_true(fabs((double)values[4 * 640 + 1] - 0.5) < 1e-6);
    for (int i = 1; i < 1281; i++) // the share never decreases
        assert_true((double)values[4 * i + 1] >= (double)values[4 * i - 3] - 1e-6);
    free(values);
    print_message("# edge: worst error %.2g\n", worst);
    assert_true(worst < closed_form);
}

TEST(two_discs_overlap_in_a_lens)
{
    static const float radii[] = {0.05f, 0.3f, 0.8f, 1.0f, 1.7f, 6.0f, 40.0f, 1000.0f};
    double worst = 0.0;
    for (size_t k = 0; k < sizeof radii / sizeof *radii; k++) {
        const float numbers[4] = {radii[k]};
        float *values = gpu_call(SHADER, 513, 1, DISC, numbers);
        for (int i = 0; i < 513; i++) {
            double disc[2] = {(double)values[4 * i] + (double)radii[k], (double)radii[k]};
            double seen = (double)values[4 * i + 1];
            if (i % 32 == 0)
                worst = fmax(worst, fabs(seen - part_of_disc(beside_disc, disc)));
        }
        free(values);
    }
    print_message("# disc: worst error %.2g\n", worst);
    assert_true(worst < closed_form);
}

// ---- Edges and balls in space ----

// The largest error for balls with angular radii from 0.3 to 72 degrees.
static double worst_ball(float spread)
{
    static const float balls[][2] = {{0.01f, 2.0f}, {0.1f, 2.0f}, {0.25f, 2.0f},
                                     {0.4f, 2.0f},  {1.0f, 2.0f}, {1.9f, 2.0f}};
    double worst = 0.0;
    for (size_t k = 0; k < sizeof balls / sizeof *balls; k++) {
        const float numbers[4] = {spread, balls[k][0], balls[k][1]};
        float *values = gpu_call(SHADER, 65, 1, BALL, numbers);
        for (int i = 0; i < 65; i += 12) {
            struct mirror_ball ball = {d3_of(values + 4 * i), (double)balls[k][0]};
            double truth = shadow_share(mirror_ball_blocks, &ball, to_light, (double)spread, GRID);
            worst = fmax(worst, fabs((double)values[4 * i + 3] - truth));
        }
        free(values);
    }
    return worst;
}

// The header of lampBesideBall states an error of at most 0.1 spread^2, to which the error of the
// grid is added.
TEST(a_ball_hides_nearly_a_disc)
{
    static const float spreads[] = {0.0047f, 0.04f, 0.1f};
    for (size_t k = 0; k < sizeof spreads / sizeof *spreads; k++) {
        double spread = (double)spreads[k], worst = worst_ball(spreads[k]);
        print_message("# ball, spread %g: worst error %.2g, %.2f spread^2\n", spread, worst,
                      worst / (spread * spread));
        assert_true(worst < 0.1 * spread * spread + 5e-5);
        assert_true(spread > 0.04 || worst < closed_form);
    }
}

struct edge {
    struct d3 normal; // of the plane through the point and the edge, on the free side
};

static bool edge_blocks(struct d3 direction, const void *data)
{
    return d3_dot(direction, ((const struct edge *)data)->normal) < 0.0;
}

TEST(an_edge_in_space_is_a_line_on_the_disc)
{
    static const float clears[] = {-0.7f, 0.1f, 0.9f};
    struct d3 aside = d3_unit(d3_cross(to_light, d3(0.0, 1.0, 0.0))),
              across = d3_cross(to_light, aside);
    double worst = 0.0;
    for (int k = 0; k < 3; k++) {
        double spread = 0.04, clear = (double)clears[k];
        const float numbers[4] = {0.04f, clears[k]};
        float *values = gpu_call(SHADER, 31, 1, EDGE_IN_SPACE, numbers);
        for (int i = 0; i < 31; i += 6) {
            struct d3 middle = d3_sub(to_light, d3_times(clear * spread, aside));
            struct d3 on_edge = d3_add(d3_times(3.0, middle), d3_times(0.7, across));
            struct edge edge = {d3_cross(on_edge, d3_of(values + 4 * i))};
            double truth = shadow_share(edge_blocks, &edge, to_light, spread, GRID);
            worst = fmax(worst, fabs((double)values[4 * i + 3] - truth));
        }
        free(values);
    }
    print_message("# edge in space: worst error %.2g\n", worst);
    assert_true(worst < closed_form);
}

// ---- Rays ----

// discPoint maps equal areas to equal areas: it cuts the disc into rings of equal area and into
// equal sectors.
TEST(equal_areas_go_to_equal_areas)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 256, 256, POINT, none);
    for (int i = 0; i < 256 * 256; i++) {
        const float *v = values + 4 * i;
        double u = (double)v[0], turn = 2.0 * MIRROR_PI * (double)v[1];
        double x = (double)v[2], y = (double)v[3];
        assert_true(fabs(x * x + y * y - u) < 1e-5); // the share of the area within this radius
        assert_true(fabs(x - sqrt(u) * cos(turn)) < 1e-5 && fabs(y - sqrt(u) * sin(turn)) < 1e-5);
    }
    free(values);
}

// The first six lamps are on the coordinate axes; those on the y axis need the special case of the
// frame around the direction.
TEST(a_ray_goes_to_its_point_on_the_lamp)
{
    const float numbers[4] = {0.2f};
    float *values = gpu_call(SHADER, 256, 1, DIRECTION, numbers);
    for (int i = 0; i < 256; i++) {
        const float *v = values + 4 * i;
        assert_true(fabs((double)v[0] - 1.0) < 1e-6);
        // Each point on the lamp is half a radius from the lamp's centre.
        assert_true(fabs((double)v[2] / (double)v[1] - 0.1) < 1e-5);
    }
    free(values);
}

// The mean over 16,384 pixels, each with different random rays from the same point, is the visible
// share to within three standard errors. The threshold makes the ball larger by 1e-5.
TEST(the_mean_of_the_rays_is_the_visible_share)
{
    enum { SIDE = 128, POINTS = SIDE * SIDE };
    for (int side = 1; side <= 4; side++) {
        const float numbers[4] = {0.08f, 0.4f, 2.0f, (float)side};
        float *values = gpu_call(SHADER, SIDE, SIDE, RAYS, numbers);
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < POINTS; i++) {
            sum += (double)values[4 * i];
            squares += (double)values[4 * i] * (double)values[4 * i];
        }
        struct mirror_ball ball = {d3_of(values + 1), 0.4};
        double mean = sum / POINTS, variance = squares / POINTS - mean * mean;
        double error = sqrt(variance / POINTS);
        double truth = shadow_share(mirror_ball_blocks, &ball, to_light, 0.08, GRID);
        free(values);
        print_message(
            "# %d rays: mean %.4f, visible share %.4f; off by %.2f standard errors of %.4f\n",
            side * side, mean, truth, (mean - truth) / error, error);
        assert_true(fabs(mean - truth) < 3.0 * error + 1e-4);
    }
}

// ---- One march ----

// The free angle is computed from the ball's position, because GLSL bounds the error of no function
// with which the shader places the ball. Only where t > 1 is distance / t near the sine of any of
// these angles. There |p - ball| < 3 t, and the rounding of p, of p - ball and of its length, whose
// root may err by 9 u, u = 2^-24, changes distance / t by less than 50 u = 3e-6.
TEST(the_clearance_lies_between_its_bounds)
{
    const float numbers[4] = {0.04f, 0.4f, 2.0f};
    float *values = gpu_call(SHADER, 256, 64, CLEARANCE, numbers);
    double rounding = 3e-6, widest = 0.0;
    for (int i = 0; i < 256 * 64; i++) {
        const float *v = values + 4 * i;
        double most = (double)v[0], least = (double)v[1];
        double along = (double)v[2], aside = (double)v[3];
        double angle = atan2(aside, along) - asin((double)numbers[1] / hypot(along, aside));
        assert_true(most >= sin(angle) - rounding);
        assert_true(least <= tan(angle) + rounding);
        widest = fmax(widest, most / least);
    }
    free(values);
    print_message("# most / least up to %.2f\n", widest);
}

// The bounds of a march in double precision, for obstacles of three kinds.
TEST(the_bounds_hold_for_sheet_and_bar_too)
{
    for (int obstacle = 0; obstacle < SHADOW_OBSTACLES; obstacle++)
        for (int i = 0; i < 4000; i++) {
            struct shadow_case scene = {(enum shadow_obstacle)obstacle, 0.5 + 0.001 * i,
                                        0.02 + 1.9 * random_of(i, 0, 0, 0)};
            double most, least, angle = atan(shadow_clearance(&scene));
            shadow_march(&scene, &most, &least);
            assert_true(most == 0.0 || most >= sin(angle) - 1e-12);
            assert_true(least <= tan(angle) + 1e-12);
        }
}

// The errors in the table of docs/13_soft_shadows.md, which build/tests/measure shadows prints.
TEST(one_march_is_too_dark)
{
    for (int i = 0; i < SHADOW_OBSTACLES; i++) {
        enum shadow_obstacle obstacle = (enum shadow_obstacle)i;
        struct shadow_error error[SHADOW_FORMULAS];
        for (int k = 0; k < SHADOW_FORMULAS; k++)
            error[k] = shadow_error_of(obstacle, (enum shadow_formula)k);
        for (int k = SHADOW_CONE; k <= SHADOW_LEAST; k++)
            assert_true(fabs(error[k].mean + error[k].mean_size) < 0.002);
        assert_true(fabs(error[SHADOW_HARD].mean) < 0.01);
        assert_true(error[SHADOW_HARD].mean_size < error[SHADOW_MOST].mean_size);
        assert_true(error[SHADOW_MOST].mean_size < error[SHADOW_LEAST].mean_size);
        assert_true(error[SHADOW_TWICE].mean_size < error[SHADOW_HARD].mean_size - 0.01);
        assert_true(error[SHADOW_SIGNED].mean_size < 0.03);
        if (obstacle == SHADOW_SHEET) {
            // Integration gives mean absolute errors of 1 / (3 pi) and 1 / 8.
            assert_true(fabs(error[SHADOW_HARD].mean_size - 1.0 / (3.0 * MIRROR_PI)) < 0.001);
            assert_true(fabs(error[SHADOW_MOST].mean_size - 0.125) < 0.002);
        }
    }
}

TESTS(gpu_setup, gpu_teardown)
