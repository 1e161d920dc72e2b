#include "lib/limits.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#define SHADER "tests/shaders/limits.frag"
#define SIZE   1.2 // as in the shader

static const double unit = MIRROR_FLOAT_ROUNDING, far = 8.0;

static double sheet_distance(int sheet, struct d3 p, struct d3 middle)
{
    struct d3 q = d3_sub(p, middle);
    return fabs(sheet == 0 ? mirror_sphere(q, 1.0)
                           : mirror_box(q, d3((double)0.7f, 0.5, (double)0.6f)));
}

// The t at which a ray that begins outside first meets the sheet, or HUGE_VAL if the ray misses the
// sheet.
static double first_meeting(int sheet, struct mirror_ray ray, struct d3 middle)
{
    double t[2];
    struct mirror_ray moved = {d3_sub(ray.origin, middle), ray.direction};
    struct d3 half = d3((double)0.7f, 0.5, (double)0.6f), low = d3_times(-1.0, half);
    bool met = sheet == 0 ? mirror_ball_crossing(moved, 1.0, t) && t[0] > 0.0
                          : brute_box_interval(moved, low, half, t);
    return met ? t[0] : HUGE_VAL;
}

// The bound of proof 5 in docs/16_fewer_steps.md: how far the computed distance at t may be from
// the true distance.
static double error_bound(struct mirror_ray ray, struct d3 middle, double t)
{
    struct d3 p = mirror_at(ray, t);
    return 1.00001 * unit * (t + d3_length(p) + 6.0 * (d3_length(d3_sub(p, middle)) + SIZE));
}

// Does the ray clearly cross the sheet? A ray that only grazes the sheet is not counted, because
// the rounding of its direction decides whether it meets the sheet.
static bool crosses(int sheet, struct mirror_ray ray, struct d3 middle, double t, double threshold)
{
    if (t == HUGE_VAL)
        return false;
    struct d3 inside = mirror_at(ray, t + 40.0 * threshold);
    struct d3 q = d3_sub(inside, middle);
    double depth =
        sheet == 0 ? mirror_sphere(q, 1.0) : mirror_box(q, d3((double)0.7f, 0.5, (double)0.6f));
    return depth < -2.0 * threshold;
}

struct limits_sums limits_of(int sheet, double away, double threshold)
{
    const float numbers[4] = {(float)away, (float)threshold, 0.0f, 0.0f};
    float *values = gpu_call(SHADER, LIMITS_CASES, 3, sheet, numbers);
    struct d3 middle = d3((double)(numbers[0] * 1.0f), (double)(numbers[0] * 0.37f),
                          (double)(numbers[0] * -0.61f));
    struct limits_sums sums = {0};
    for (int i = 0; i < LIMITS_CASES; i++) {
        const float *origin = values + 4 * i, *direction = origin + 4 * LIMITS_CASES,
                    *asked = direction + 4 * LIMITS_CASES;
        struct mirror_ray ray = {d3_of(origin), d3_of(direction)};
        double t = (double)asked[0], end = (double)origin[3];
        double error = fabs((double)asked[1] - sheet_distance(sheet, mirror_at(ray, t), middle));
        sums.error = fmax(sums.error, error / error_bound(ray, middle, t));
        sums.absolute = fmax(sums.absolute, error);
        double at = unit * (2.0 * d3_length(ray.origin) + 14.0 * end + 24.0 * SIZE);
        sums.threshold =
            fmax(sums.threshold, unit * (2.0 * d3_length(ray.origin) + 14.0 * 4.0 + 24.0 * SIZE));
        double meets = first_meeting(sheet, ray, middle);
        if (!crosses(sheet, ray, middle, meets, at) || meets > far - 1.0)
            continue;
        sums.rays++;
        sums.passed += direction[3] < 0.5f || end > meets + at;
    }
    free(values);
    return sums;
}

// The largest power of two, from 1 down to 1e-6, for which a ray passes a sheet if the threshold is
// the proved threshold times this power. Returns 0 if there is none.
static double largest_unsound(double away)
{
    for (double threshold = 1.0; threshold > 1e-6; threshold *= 0.5)
        for (int sheet = 0; sheet < LIMITS_SHEETS; sheet++)
            if (limits_of(sheet, away, threshold).passed > 0)
                return threshold;
    return 0.0;
}

int limits_print(void)
{
    printf(
        "# %d rays from 4 units away to each of two sheets without thickness, a hollow ball and a "
        "hollow box, far from the origin\n",
        LIMITS_CASES);
    printf("away,spacing of floats,largest error of a distance,error over its bound,proved "
           "threshold at t = 4,rays that pass with it,rays that pass with a 16th of it,largest "
           "threshold that fails\n");
    for (double away = 1.0; away < 2e5; away *= 10.0) {
        struct limits_sums ball = limits_of(0, away, 1.0), box = limits_of(1, away, 1.0);
        struct limits_sums less = limits_of(0, away, 1.0 / 16.0),
                           other = limits_of(1, away, 1.0 / 16.0);
        double fails = largest_unsound(away);
        printf("%g,%.2g,%.2g,%.2f,%.2g,%d,%d,%.2g\n", away, ldexp(FLT_EPSILON, ilogb(away)),
               fmax(ball.absolute, box.absolute), fmax(ball.error, box.error), ball.threshold,
               ball.passed + box.passed, less.passed + other.passed, fails * ball.threshold);
    }
    return 0;
}
