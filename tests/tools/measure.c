// measure.c - build/tests/measure NAME prints a table of numbers that the pages quote.
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform.h"
#include "lib/bound.h"
#include "lib/bounces.h"
#include "lib/checkers.h"
#include "lib/filter.h"
#include "lib/glass.h"
#include "lib/gloss.h"
#include "lib/levels.h"
#include "lib/limits.h"
#include "lib/marches.h"
#include "lib/measure.h"
#include "lib/occlusion.h"
#include "lib/paths.h"
#include "lib/report_pictures.h"
#include "lib/sky_table.h"
#include "lib/speed.h"

static int print_normal(void)
{
    static const double steps[] = {1e-7, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3};
    printf("# largest error of the normal of the unit ball at z = 10 in 32-bit floats, degrees\n");
    printf("step,central,central_truncation,forward,forward_truncation,rounding_bound\n");
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        struct normal_error e = measure_normal(steps[i]);
        printf("%g,%.3g,%.3g,%.3g,%.3g,%.3g\n", steps[i], e.central, e.central_truncation,
               e.forward, e.forward_truncation, e.rounding);
    }
    return 0;
}

static int print_plane(void)
{
    static const double angles[] = {90.0, 60.0, 45.0, 30.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5};
    static const int limits[] = {60, 64, 128, 256};
    printf(
        "# moves to a plane from height 1, threshold 0.001; a march makes one evaluation more\n");
    printf("degrees,moves,formula\n");
    for (size_t i = 0; i < sizeof angles / sizeof angles[0]; i++)
        printf("%g,%d,%d\n", angles[i], measure_plane_moves(angles[i], 0.001),
               measure_plane_formula(angles[i], 0.001));
    printf("# the angle, in degrees, below which this many evaluations do not reach the plane\n");
    printf("evaluations,threshold_0.01,threshold_0.001,threshold_0.0005\n");
    for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++)
        printf("%d,%.2f,%.2f,%.2f\n", limits[i], measure_plane_limit(limits[i], 0.01),
               measure_plane_limit(limits[i], 0.001), measure_plane_limit(limits[i], 0.0005));
    return 0;
}

static int print_sphere(void)
{
    printf("# moves past a ball of radius 1, from 3 before the closest point to 3 beyond it\n");
    printf("miss,threshold,moves,formula\n");
    for (double delta = 1e-2; delta > 5e-6; delta /= 10.0)
        printf("%g,%g,%d,%.1f\n", delta, delta / 10.0, measure_ball_moves(delta, delta / 10.0),
               MIRROR_PI * sqrt(2.0 / delta));
    for (double threshold = 1e-2; threshold > 5e-6; threshold /= 10.0)
        printf("0,%g,%d,%.1f\n", threshold, measure_ball_moves(0.0, threshold),
               sqrt(2.0 / threshold));
    return 0;
}

static int print_rate(void)
{
    printf("# near a transversal hit on a ball: e_(n+1) / e_n, where e_n = t* - t_n\n");
    printf("cosine,ratio,1 - cosine\n");
    for (int i = 1; i < 10; i++)
        printf("%.1f,%.4f,%.1f\n", 0.1 * i, measure_rate(0.1 * i), 1.0 - 0.1 * i);
    return 0;
}

static int print_foot(void)
{
    printf(
        "# largest angle, in degrees, between the ball's normal below the end of a march and its "
        "normal where the ray meets the ball\n");
    printf("radius,threshold,measured,arccos(r / (r + threshold)),sqrt(2 threshold / r)\n");
    static const double cases[][2] = {{1.0, 5e-4},  {0.52, 5e-4}, {0.27, 5e-4},
                                      {0.16, 5e-4}, {1.0, 1e-2},  {1.0, 1e-5}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        double radius = cases[i][0], threshold = cases[i][1], degrees = 180.0 / MIRROR_PI;
        printf("%g,%g,%.2f,%.2f,%.2f\n", radius, threshold, measure_foot(radius, threshold),
               acos(radius / (radius + threshold)) * degrees,
               sqrt(2.0 * threshold / radius) * degrees);
    }
    return 0;
}

static int print_threshold(void)
{
    static const double thresholds[] = {0.0001, 0.001, 0.01, 0.05, 0.1, 0.2};
    double exact = measure_outline_theory(0.0);
    printf("# outline of a ball of radius 1 at a distance of 5, 640x360: radius %.3f pixels\n",
           exact);
    printf("threshold,grown_by,expected\n");
    for (size_t i = 0; i < sizeof thresholds / sizeof thresholds[0]; i++) {
        printf("%g,%.3f,%.3f\n", thresholds[i], measure_outline(thresholds[i]) - exact,
               measure_outline_theory(thresholds[i]) - exact);
    }
    return 0;
}

static int print_acne(void)
{
    static const double offsets[] = {0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 4.0, 10.0};
    printf("# chapter 03: share of the stage's lit pixels that are wrongly in their own shadow\n");
    printf("offset_in_thresholds,share\n");
    for (size_t i = 0; i < sizeof offsets / sizeof offsets[0]; i++) {
        printf("%g,%.4f\n", offsets[i], measure_acne(offsets[i]));
    }
    return 0;
}

static void print_bound_row(const char *stem, const char *rays, const struct bound_sums *sum)
{
    printf("%s,%s,%d,%.2f,%.2f,%.2f,%.2f,%.2f,%.4f\n", stem, rays, sum->rays,
           (double)sum->march / sum->rays, (double)sum->least / sum->rays,
           (double)sum->most / sum->rays, (double)sum->march / sum->least, sum->smallest,
           sum->lipschitz);
}

// Print the evaluations along rays that start at height 1 above a plane. A ray at a positive angle
// approaches the plane, and a ray at a negative angle leaves it.
static void print_bound_planes(void)
{
    static const double angles[] = {60.0, 45.0, 30.0, 10.0, 5.0, 0.0, -5.0, -10.0, -30.0, -60.0};
    printf("# evaluations along a ray of length 10000 above a plane, threshold 1e-9\n");
    printf("degrees,march,least,march / least,formula\n");
    for (size_t i = 0; i < sizeof angles / sizeof angles[0]; i++) {
        bool hit;
        double slope = sin(angles[i] * MIRROR_PI / 180.0);
        int march = cover_plane_march(1.0, slope, 1e4, 1e-9, &hit);
        int least = cover_plane_least(1.0, slope, 1e4, 1e-9);
        printf("%g,%d,%d,%.2f,%.2f\n", angles[i], march, least, (double)march / least,
               cover_plane_ratio(slope));
    }
}

static int print_bound(void)
{
    print_bound_planes();
    printf("# evaluations per ray: of the march, and bounds on the smallest possible number, least "
           "and most\n");
    printf("chapter,end,rays,march,least,most,march / least,smallest ratio of one ray,slope\n");
    for (int i = 0; i < bound_case_count; i++) {
        struct bound_sums sum[2];
        bound_measure(&bound_cases[i], 1, sum);
        print_bound_row(bound_cases[i].stem, "hit", &sum[1]);
        print_bound_row(bound_cases[i].stem, "miss", &sum[0]);
    }
    return 0;
}

static void print_shadow_row(const char *scene, const char *formula,
                             const struct shadow_error *error)
{
    printf("%s,%s,%.3f,%.3f,%.3f\n", scene, formula, error->mean, error->mean_size, error->worst);
}

// Returns whether the parapet of chapter 13's worked example hides a direction. Its upper edge is
// 0.4 high, at a horizontal distance of 0.43.
static bool wall_blocks(struct d3 direction, const void *unused)
{
    (void)unused;
    return 0.43 * direction.y + 0.4 * direction.z < 0.0;
}

static void print_wall(void)
{
    double up = 29.0 * MIRROR_PI / 180.0, turn = 214.0 * MIRROR_PI / 180.0, spread = 0.04;
    struct d3 sun = d3(cos(up) * cos(turn), sin(up), cos(up) * sin(turn));
    double sine = (0.43 * sun.y + 0.4 * sun.z) / hypot(0.43, 0.4);
    double clear = sine / sqrt(1.0 - sine * sine) / spread;
    double share = 0.5 + (asin(clear) + clear * sqrt(1.0 - clear * clear)) / MIRROR_PI;
    printf("# 0.43 in front of a wall 0.4 high: clear %.3f, visible %.4f; from 2000 x 2000 points "
           "%.4f\n",
           clear, share, shadow_share(wall_blocks, NULL, sun, spread, 2000));
}

// The mean number of a unit disc's side x side cells that a straight edge cuts, over edges from x =
// -0.95 to 0.95. The cells are bounded in polar coordinates. An edge cuts a cell if it is between
// the corners of the cell, because x = r cos(angle) is monotonic in r and in the angle.
static double cells_cut(int side)
{
    double length = 0.0;
    for (int cell = 0; cell < side * side; cell++) {
        double least = 0.95, most = -0.95;
        for (int corner = 0; corner < 4; corner++) {
            int ring = cell / side + corner / 2, sector = cell % side + corner % 2;
            double x = sqrt(1.0 * ring / side) * cos(2.0 * MIRROR_PI * sector / side);
            least = fmin(least, x);
            most = fmax(most, x);
        }
        length += fmax(fmin(most, 0.95) - fmax(least, -0.95), 0.0);
    }
    return length / 1.9;
}

static int print_shadows(void)
{
    static const enum shadow_formula in_scene[] = {SHADOW_HARD, SHADOW_MOST, SHADOW_LEAST,
                                                   SHADOW_TWICE, SHADOW_SIGNED};
    struct shadow_error error;
    print_wall();
    printf("# visible share of the sun: formula minus truth; the sun has a radius of 0.04 and is "
           "29 degrees high\n");
    printf("scene,formula,mean,mean absolute value,worst\n");
    for (int obstacle = 0; obstacle < SHADOW_OBSTACLES; obstacle++)
        for (int formula = 0; formula < SHADOW_FORMULAS; formula++) {
            error = shadow_error_of((enum shadow_obstacle)obstacle, (enum shadow_formula)formula);
            print_shadow_row(shadow_obstacle_names[obstacle], shadow_formula_names[formula],
                             &error);
        }
    struct shadow_error scene[5];
    measure_shadow_scene(scene);
    for (int i = 0; i < 5; i++)
        print_shadow_row("chapter 13", shadow_formula_names[in_scene[i]], &scene[i]);
    printf("# of the disc's 8 x 8 cells, an edge cuts %.1f on average\n", cells_cut(8));
    return 0;
}

// Print the share of the light that each highlight sends back, for several angles to the eye and as
// a mean over all directions.
static int print_gloss(void)
{
    static const double roughnesses[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
    printf("# share of the light that perfectly reflecting facets send back: GGX, Blinn-Phong\n");
    printf("roughness,at 0 degrees,at 60 degrees,at 80 degrees,mean,exponent,at 0 degrees,at 60 "
           "degrees,at 80 "
           "degrees,mean,(n + 8) / (8 pi),no factor\n");
    for (size_t i = 0; i < sizeof roughnesses / sizeof roughnesses[0]; i++) {
        double r = roughnesses[i], n = gloss_exponent(r), steep = cos(80.0 * MIRROR_PI / 180.0);
        printf("%g,%.3f,%.3f,%.3f,%.3f,%.3g,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f\n", r,
               gloss_albedo(gloss_ggx, r, r, 1.0), gloss_albedo(gloss_ggx, r, r, 0.5),
               gloss_albedo(gloss_ggx, r, r, steep), gloss_mean_albedo(gloss_ggx, r, r), n,
               gloss_albedo(gloss_blinn_phong, n, r, 1.0),
               gloss_albedo(gloss_blinn_phong, n, r, 0.5),
               gloss_albedo(gloss_blinn_phong, n, r, steep),
               gloss_mean_albedo(gloss_blinn_phong, n, r), gloss_albedo(gloss_usual, n, r, 1.0),
               gloss_albedo(gloss_bare, n, r, 1.0));
    }
    return 0;
}

// Print the error of each method of colouring a pixel of the squares, compared with the mean of
// 64 x 64 samples of that pixel.
static int print_checkers(void)
{
    static const char *const ways[] = {"middle of the pixel", "footprint of the ray", "fwidth"};
    printf("# squares of the experiment 11_checkers: root mean square error of the mean over the "
           "pixel, on a scale from 0 to 255\n");
    printf("orthographic,way,off\n");
    for (int v = 0; v < 3; v++)
        for (int way = 0; way < 3; way++) {
            const struct checkers_view *view = &checkers_views[v];
            double *share = checkers_shown(view, way), squares = 0.0;
            int count = 0;
            for (int y = 1; y < CHECKERS_HEIGHT; y += 5)
                for (int x = 2; x < CHECKERS_WIDTH; x += 11) {
                    double low[2], high[2];
                    if (checkers_hidden(view, x, y) || !checkers_rectangle(view, x, y, low, high))
                        continue;
                    double off = share[y * CHECKERS_WIDTH + x] - checkers_of_pixel(view, x, y);
                    squares += off * off;
                    count++;
                }
            free(share);
            printf("%g,%s,%.2f\n", view->orthographic, ways[way], 255.0 * sqrt(squares / count));
        }
    return 0;
}

static int print_levels(void)
{
    static const double factors[] = {0.0, 0.25, 0.5, 1.0, 2.0, 4.0};
    if (!levels_open())
        return 1;
    printf("# granite.png read with a multiple of the footprint: root mean square difference "
           "from the mean over the footprint, on a scale from 0 to 1\n");
    printf("texels,sine,none,1/4,1/2,1,2,4\n");
    for (double sine = 1.0; sine > 0.05; sine /= 4.0)
        for (double n = 1.0; n <= 32.0; n *= 2.0) {
            printf("%g,%g", n, sine);
            for (size_t i = 0; i < sizeof factors / sizeof factors[0]; i++)
                printf(",%.3f", levels_error(n, n / sine, factors[i], sine));
            printf("\n");
        }
    return 0;
}

// Print the errors of means of a few samples, compared with the mean of 256.
static int print_filters(void)
{
    printf("# a fan of fine rays, 64 x 64 pixels: root mean square difference from 256 samples of "
           "the same filter (for the workshop, of the box filter), on a scale from 0 to 1\n");
    printf("samples");
    for (int way = 0; way < FILTER_WAYS; way++)
        printf(",%s", filter_way_names[way]);
    printf("\n");
    for (int side = 1; side <= 8; side++) {
        printf("%d", side * side);
        for (int way = 0; way < FILTER_WAYS; way++)
            printf(",%.3f", filter_error((enum filter_way)way, side));
        printf("\n");
    }
    return 0;
}

// ---- The command line ----

static const struct measurement {
    const char *name, *what;
    bool needs_gpu;
    int (*print)(void);
} measurements[] = {
    {"normal", "error of the normal against the step of its differences", false, print_normal},
    {"plane", "steps to a plane against the angle", false, print_plane},
    {"sphere", "steps past a ball", false, print_sphere},
    {"rate", "how fast a march approaches a hit", false, print_rate},
    {"foot", "normal below the end of a march, compared with that where the ray hits", false,
     print_foot},
    {"threshold", "how much a threshold enlarges an outline", true, print_threshold},
    {"acne", "share of lit pixels wrongly in their own shadow, against the offset", true,
     print_acne},
    {"bound", "evaluations of a march against the smallest number possible", true, print_bound},
    {"shadows", "soft shadows from one march, against the visible share of the sun", true,
     print_shadows},
    {"occlusion", "the visible share of the sky from five taps, against the truth", true,
     occlusion_print},
    {"paths", "the light of chapters 13 and 14, against paths of light in their scenes", true,
     paths_print},
    {"bounces", "chapter 24's mean light, its error against the number of frames, its bounces",
     true, bounces_print},
    {"quiet", "chapter 24's filter, and what is kept while the eye moves, against many frames",
     true, bounces_print_quiet},
    {"glass", "share of the light that glass reflects; light missing after a number of surfaces",
     true, glass_print},
    {"gloss", "share of the light that a highlight sends back", false, print_gloss},
    {"filters", "error of a pixel's mean against the number and positions of its samples", false,
     print_filters},
    {"checkers", "squares averaged over a pixel in three ways, against samples", true,
     print_checkers},
    {"levels", "error of a texture against the footprint that selects its level", true,
     print_levels},
    {"sky", "a sky from tables and with other methods, against the integral", true,
     sky_table_print},
    {"limits", "a march in floats far from the origin, and the least sound threshold", true,
     limits_print},
    {"marches", "seven marches in eleven scenes: evaluations, time, lockstep, errors", true,
     marches_print},
    {"report", "costs of three of the report's pictures, compared with those of its engine", true,
     report_print},
};
enum { MEASUREMENTS = sizeof measurements / sizeof *measurements };

static int usage(FILE *file)
{
    fputs("Usage: measure NAME\n", file);
    for (int i = 0; i < MEASUREMENTS; i++)
        fprintf(file, "  %-9s  %s\n", measurements[i].name, measurements[i].what);
    fputs("  speed A.frag B.frag [WxH]\n"
          "             CPU time of two shaders, with alternating frames, and of their cold "
          "starts;\n"
          "             A.frag@X,Y,Z,PAN,TILT sets the camera\n",
          file);
    return file == stdout ? 0 : 2;
}

int main(int argc, char **argv)
{
    const struct measurement *wanted = measurements;
    if (argc < 2)
        return usage(stdout);
    bool speed = strcmp(argv[1], "speed") == 0;
    while (wanted < measurements + MEASUREMENTS && strcmp(argv[1], wanted->name) != 0)
        wanted++;
    if (wanted == measurements + MEASUREMENTS && !speed)
        return usage(stderr);
    if (!speed && !wanted->needs_gpu)
        return wanted->print();
    // A cold start is one without the driver's cache of compiled shaders.
    if (speed)
        platform_set("MESA_SHADER_CACHE_DISABLE", "true", true);
    int status = !gpu_open() ? 1 : speed ? speed_print(argc, argv) : wanted->print();
    gpu_close();
    return status;
}
