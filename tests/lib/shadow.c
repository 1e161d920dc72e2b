#include "lib/shadow.h"

#include <stdlib.h>

#define SPREAD    0.04
#define ELEVATION (29.0 * MIRROR_PI / 180.0)
#define OFFSET    0.002
#define THRESHOLD 0.0005
#define BALL      0.42 // radius, scene units
#define BAR       0.4  // half the width of the bar, in radii of the lamp

const char *const shadow_obstacle_names[SHADOW_OBSTACLES] = {"half-plane", "ball", "bar"};
const char *const shadow_formula_names[SHADOW_FORMULAS] = {
    "hard",           "cone of chapter 06",  "distance / t",
    "pairs of steps", "pairs twice as hard", "march on inside objects"};

void shadow_axes(struct d3 to_light, struct d3 *right, struct d3 *up)
{
    struct d3 axis = fabs(to_light.y) < 0.9 ? d3(0.0, 1.0, 0.0) : d3(1.0, 0.0, 0.0);
    *right = d3_unit(d3_cross(to_light, axis));
    *up = d3_cross(*right, to_light);
}

double shadow_share(shadow_blocked blocked, const void *data, struct d3 to_light, double spread,
                    int n)
{
    struct d3 right, up;
    long all = 0, seen = 0;
    shadow_axes(to_light, &right, &up);
    for (int i = 0; i < n * n; i++) {
        double x = (2.0 * (i % n) + 1.0) / n - 1.0, y = (2.0 * (i / n) + 1.0) / n - 1.0;
        if (x * x + y * y > 1.0)
            continue;
        struct d3 offset = d3_add(d3_times(spread * x, right), d3_times(spread * y, up));
        all++;
        seen += !blocked(d3_unit(d3_add(to_light, offset)), data);
    }
    return (double)seen / (double)all;
}

// ---- The table of errors ----

// Find the radius of a round object, half the angle that it subtends at the point, and the angle
// between its centre and the ray.
static void round_thing(const struct shadow_case *scene, double *radius, double *half,
                        double *angle)
{
    *radius = scene->obstacle == SHADOW_BALL ? BALL : scene->distance * sin(atan(BAR * SPREAD));
    *half = asin(*radius / scene->distance);
    *angle = *half + atan(scene->clear * SPREAD);
}

// The distance to the obstacle from the point of the ray at t.
static double obstacle_distance(const struct shadow_case *scene, double t)
{
    if (scene->obstacle == SHADOW_SHEET) {
        // The obstacle is everything that is at least as far ahead as the edge and on one side of a
        // plane through the point and the edge. It is a wall instead of a sheet, because it must
        // have an inside.
        double edge = scene->clear * SPREAD * scene->distance;
        double ahead = scene->distance - t;
        double length = sqrt(1.0 + scene->clear * SPREAD * scene->clear * SPREAD);
        double beside = scene->clear * SPREAD * t / length; // from the side of the wall
        double along = t / length;                          // along that side, from the point
        double corner = hypot(edge, scene->distance);
        if (beside <= 0.0)
            return ahead > 0.0 ? (edge <= 0.0 ? ahead : hypot(ahead, edge)) : fmax(ahead, beside);
        return along >= corner ? beside : hypot(edge, ahead);
    }
    double radius, half, angle;
    round_thing(scene, &radius, &half, &angle);
    double x = scene->distance * sin(angle), y = scene->distance * cos(angle) - t;
    return hypot(x, y) - radius;
}

static double scene_distance(const struct shadow_case *scene, double t)
{
    return fmin(OFFSET + t * sin(ELEVATION), obstacle_distance(scene, t));
}

double shadow_clearance(const struct shadow_case *scene)
{
    return scene->clear * SPREAD;
}

// The share of a disc on one side of a line, summed over chords of the disc.
static double beside(double clear)
{
    enum { CHORDS = 500 };
    double sum = 0.0, c = fmin(fmax(clear, -1.0), 1.0);
    for (int i = 0; i < CHORDS; i++) {
        double x = -1.0 + (c + 1.0) * (i + 0.5) / CHORDS;
        sum += 2.0 * sqrt(1.0 - x * x) * (c + 1.0) / CHORDS;
    }
    return sum / MIRROR_PI;
}

static bool ball_blocks(struct d3 direction, const void *data)
{
    const struct shadow_case *scene = data;
    double radius, half, angle;
    round_thing(scene, &radius, &half, &angle);
    struct d3 right, up, ahead = d3(0.0, 0.0, 1.0);
    shadow_axes(ahead, &right, &up);
    struct d3 middle = d3_add(d3_times(cos(angle), ahead), d3_times(sin(angle), right));
    return d3_dot(direction, middle) > cos(half);
}

double shadow_truth(const struct shadow_case *scene)
{
    if (scene->obstacle == SHADOW_SHEET)
        return beside(scene->clear);
    if (scene->obstacle == SHADOW_BALL)
        return shadow_share(ball_blocks, scene, d3(0.0, 0.0, 1.0), SPREAD, 120);
    double radius, half, angle;
    round_thing(scene, &radius, &half, &angle);
    return beside(tan(angle - half) / SPREAD) + 1.0 - beside(tan(angle + half) / SPREAD);
}

void shadow_march(const struct shadow_case *scene, double *most, double *least)
{
    double t = 0.0, before = 1e6;
    *most = *least = 1e6;
    for (int step = 0; step < 200 && t < 10.0; step++) {
        double distance = scene_distance(scene, t);
        if (distance < THRESHOLD) {
            *most = *least = 0.0;
            return;
        }
        double back = 0.5 * distance * distance / before, along = t - back;
        *most = fmin(*most, t > 0.0 ? distance / t : 1e6);
        if (along > 0.0)
            *least = fmin(*least, sqrt(fmax(distance * distance - back * back, 0.0)) / along);
        before = distance;
        t += distance;
    }
}

// coneReaching of shaders/cone.glsl in double precision.
static double cone_reaching(const struct shadow_case *scene)
{
    double t = 0.0, smallest = 1.0;
    for (int step = 0; step < 200 && t < 10.0 && smallest > 0.2; step++) {
        double distance = scene_distance(scene, t);
        smallest = fmin(smallest, distance / (THRESHOLD + SPREAD * t));
        t += distance;
    }
    return fmax((smallest - 0.2) / 0.8, 0.0);
}

// The march that continues inside the object, with steps of at least 0.01 plus a fiftieth of t.
static double on_inside(const struct shadow_case *scene)
{
    double t = 0.0, smallest = 1.0;
    for (int step = 0; step < 400 && t < 10.0 && smallest > -1.0; step++) {
        double distance = scene_distance(scene, t);
        smallest = t > 0.0 ? fmin(smallest, distance / (SPREAD * t)) : smallest;
        t += fmax(distance, 0.01 + 0.02 * t);
    }
    return beside(smallest);
}

double shadow_quick(const struct shadow_case *scene, enum shadow_formula formula)
{
    double most, least;
    if (formula == SHADOW_CONE)
        return cone_reaching(scene);
    if (formula == SHADOW_SIGNED)
        return on_inside(scene);
    shadow_march(scene, &most, &least);
    if (formula == SHADOW_HARD)
        return most > 0.0 ? 1.0 : 0.0;
    double hardness = (formula == SHADOW_TWICE ? 2.0 : 1.0) / SPREAD;
    return fmin(hardness * (formula == SHADOW_MOST ? most : least), 1.0);
}

struct shadow_error shadow_error_of(enum shadow_obstacle obstacle, enum shadow_formula formula)
{
    enum { OFFSETS = 40, DISTANCES = 5 };
    struct shadow_error error = {0.0, 0.0, 0.0};
    for (int i = 0; i < OFFSETS * DISTANCES; i++) {
        double clear = -2.0 + 4.0 * (i % OFFSETS + 0.5) / OFFSETS;
        struct shadow_case scene = {obstacle, 0.5 * pow(8.0, (i / OFFSETS) / (DISTANCES - 1.0)),
                                    clear};
        double off = shadow_quick(&scene, formula) - shadow_truth(&scene);
        error.mean += off / (OFFSETS * DISTANCES);
        error.mean_size += fabs(off) / (OFFSETS * DISTANCES);
        error.worst = fmax(error.worst, fabs(off));
    }
    return error;
}
