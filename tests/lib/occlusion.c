#include "lib/occlusion.h"

#include <stdio.h>
#include <stdlib.h>

#include "lib/gpu.h"
#include "lib/shadow.h"

#define BAR    0.05 // radius
#define GROOVE 0.6  // half the width
#define TAPS   5

const char *const occlusion_thing_names[OCCLUSION_THINGS] = {"open floor", "wall", "groove",
                                                             "bar",        "ball", "shaft"};

double occlusion_share(occlusion_blocked blocked, const void *data, struct d3 normal, int n)
{
    struct d3 right, up;
    long all = 0, seen = 0;
    shadow_axes(normal, &right, &up);
    for (int i = 0; i < n * n; i++) {
        double a = (2.0 * (i % n) + 1.0) / n - 1.0, b = (2.0 * (i / n) + 1.0) / n - 1.0;
        // The grid is rotated so that no edge of a scene is parallel to a row of points.
        double x = a * cos(1.0) - b * sin(1.0), y = a * sin(1.0) + b * cos(1.0);
        double square = 1.0 - x * x - y * y;
        if (square < 0.0)
            continue;
        struct d3 flat = d3_add(d3_times(x, right), d3_times(y, up));
        all++;
        seen += !blocked(d3_add(flat, d3_times(sqrt(square), normal)), data);
    }
    return (double)seen / (double)all;
}

// ---- One scene ----

// The distance from a point (away, y) to a wall of a given height, whose foot is at 0.
static double wall_distance(double away, double y, double height)
{
    return y < height ? away : hypot(away, y - height);
}

double occlusion_distance(const struct occlusion_case *scene, double y)
{
    double thing = HUGE_VAL, x = scene->x, size = scene->size;
    if (scene->thing == OCCLUSION_WALL || scene->thing == OCCLUSION_SHAFT)
        thing = wall_distance(x, y, size);
    else if (scene->thing == OCCLUSION_GROOVE)
        thing = wall_distance(GROOVE - fabs(x), y, size);
    else if (scene->thing != OCCLUSION_NOTHING)
        thing = hypot(x, y - size) - (scene->thing == OCCLUSION_BAR ? BAR : size);
    return fmin(thing, y);
}

// Does a ray meet an upright wall whose foot is at the height of the ray's origin?
//   away  horizontal distance from the ray's origin to the wall
//   rate  the component of the ray's direction towards the wall
//   rise  the upward component of the ray's direction
static bool meets_wall(double away, double rate, double rise, double height)
{
    return rate > 0.0 && away * rise < height * rate;
}

static bool thing_blocks(struct d3 w, const void *data)
{
    const struct occlusion_case *scene = data;
    double x = scene->x, size = scene->size;
    switch (scene->thing) {
    case OCCLUSION_WALL:
        return meets_wall(x, -w.x, w.y, size);
    case OCCLUSION_GROOVE:
        return meets_wall(GROOVE + x, -w.x, w.y, size) || meets_wall(GROOVE - x, w.x, w.y, size);
    case OCCLUSION_SHAFT:
        return meets_wall(x, hypot(w.x, w.z), w.y, size);
    case OCCLUSION_BAR: { // computed in the plane perpendicular to the bar
        double along = (-x * w.x + size * w.y) / hypot(w.x, w.y);
        return along > 0.0 && x * x + size * size - along * along < BAR * BAR;
    }
    case OCCLUSION_BALL: {
        double along = -x * w.x + size * w.y;
        return along > 0.0 && x * x + size * size - along * along < size * size;
    }
    default:
        return false;
    }
}

double occlusion_brute(const struct occlusion_case *scene, int n)
{
    return occlusion_share(thing_blocks, scene, d3(0.0, 1.0, 0.0), n);
}

// The openness in front of a wall: half of the sky, and the part of the other half above the wall.
static double before_wall(double away, double height)
{
    return 0.5 * (1.0 + cos(atan2(height, away)));
}

double occlusion_truth(const struct occlusion_case *scene)
{
    double x = scene->x, size = scene->size, far = x * x + size * size;
    switch (scene->thing) {
    case OCCLUSION_WALL:
        return before_wall(x, size);
    case OCCLUSION_GROOVE:
        return before_wall(GROOVE + x, size) + before_wall(GROOVE - x, size) - 1.0;
    case OCCLUSION_SHAFT:
        return x * x / far;
    case OCCLUSION_BAR:
        return 1.0 - BAR * size / far;
    case OCCLUSION_BALL:
        return 1.0 - pow(size / sqrt(far), 3.0);
    default:
        return 1.0;
    }
}

double occlusion_taps(const struct occlusion_case *scene, double reach, double strength)
{
    double hidden = 0.0;
    for (int k = 0; k < TAPS; k++) {
        double height = reach / pow(2.0, TAPS - 1 - k);
        hidden += mirror_clamp(1.0 - occlusion_distance(scene, height) / height) / TAPS;
    }
    return fmax(1.0 - strength * hidden, 0.0);
}

// ---- Errors ----

// One point of a field, the picture of one object, in the experiment 14_map.
static struct occlusion_case field_case(enum occlusion_thing thing, double along, double grown)
{
    double side = thing == OCCLUSION_GROOVE ? GROOVE : 1.2;
    double x = thing == OCCLUSION_WALL ? 1.5 * along : side * (2.0 * along - 1.0);
    double small = thing == OCCLUSION_BAR ? 0.1 : 0.05;
    double growth = thing == OCCLUSION_BAR ? 0.9 : (thing == OCCLUSION_BALL ? 0.55 : 1.5);
    return (struct occlusion_case){thing, small + growth * grown, x};
}

static void add_up(struct occlusion_error *error, double off, double weight)
{
    error->mean += weight * off;
    error->mean_size += weight * fabs(off);
    error->worst = fmax(error->worst, fabs(off));
}

struct occlusion_error occlusion_error_of(enum occlusion_thing thing, double strength)
{
    enum { POINTS = 120 };
    struct occlusion_error error = {0.0, 0.0, 0.0};
    for (int i = 0; i < POINTS * POINTS; i++) {
        double along = (i % POINTS + 0.5) / POINTS, grown = (i / POINTS + 0.5) / POINTS;
        struct occlusion_case scene = field_case(thing, along, grown);
        double off = occlusion_taps(&scene, 1.0, strength) - occlusion_truth(&scene);
        add_up(&error, off, 1.0 / (POINTS * POINTS));
    }
    return error;
}

struct occlusion_error occlusion_scene_error(int formula)
{
    struct renderer_inputs inputs = {.width = 160, .height = 90, .samples = 1};
    struct occlusion_error error = {0.0, 0.0, 0.0};
    inputs.camera = gpu_camera("14_occlusion");
    gpu_open_shader("tests/shaders/openness.frag");
    gpu_set("formula", formula);
    float *values = gpu_numbers(&inputs);
    int pixels = 0;
    for (int i = 0; i < 160 * 90; i++)
        pixels += values[4 * i + 1] > 0.5f;
    for (int i = 0; i < 160 * 90; i++)
        if (values[4 * i + 1] > 0.5f)
            add_up(&error, (double)values[4 * i] - (double)values[4 * i + 2], 1.0 / pixels);
    free(values);
    return error;
}

// ---- The tables of the page ----

static void print_row(const char *scene, const char *formula, const struct occlusion_error *error)
{
    printf("%s,%s,%.3f,%.3f,%.3f\n", scene, formula, error->mean, error->mean_size, error->worst);
}

static void print_case(const char *words, struct occlusion_case scene)
{
    printf("# %s: visible %.4f, by counting %.4f; taps", words, occlusion_truth(&scene),
           occlusion_brute(&scene, 2000));
    for (int k = 0; k < TAPS; k++) {
        double height = 1.0 / pow(2.0, TAPS - 1 - k);
        printf(" %.3f", mirror_clamp(occlusion_distance(&scene, height) / height));
    }
    printf(", mean %.3f\n", occlusion_taps(&scene, 1.0, 1.0));
}

int occlusion_print(void)
{
    static const char *const formulas[] = {"nothing hides", "taps at strength 1/2", "taps",
                                           "near taps count more", "1 - steps / 32"};
    print_case("0.3 from a wall 0.4 high", (struct occlusion_case){OCCLUSION_WALL, 0.4, 0.3});
    print_case("1 from a ball of radius 1", (struct occlusion_case){OCCLUSION_BALL, 1.0, 1.0});
    print_case("0.1 from a wall 4 high", (struct occlusion_case){OCCLUSION_WALL, 4.0, 0.1});
    print_case("in a shaft of radius 0.1, 4 deep",
               (struct occlusion_case){OCCLUSION_SHAFT, 4.0, 0.1});
    printf("# visible share of the sky: formula minus truth\n");
    printf("scene,formula,mean,mean absolute value,worst\n");
    for (int thing = 0; thing <= OCCLUSION_BALL; thing++)
        for (int i = 0; i < 3; i++) {
            struct occlusion_error error = occlusion_error_of((enum occlusion_thing)thing, 0.5 * i);
            print_row(occlusion_thing_names[thing], formulas[i], &error);
        }
    for (int formula = 0; formula < 5; formula++) {
        struct occlusion_error error = occlusion_scene_error(formula);
        print_row("chapter 14", formulas[formula], &error);
    }
    return 0;
}
