#include "lib/solid.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>

#include "lib/gpu.h"

#define SHADER "tests/shaders/solids.frag"
#define WIDE   256
#define ROWS   8

// ---- Surfaces ----

static struct d3 patch_at(const struct patch *patch, double u, double v)
{
    if (!patch->turned)
        return d3_add(patch->origin, d3_add(d3_times(u, patch->side), d3_times(v, patch->other)));
    double x = patch->from[0] + u * (patch->to[0] - patch->from[0]);
    double y = patch->from[1] + u * (patch->to[1] - patch->from[1]);
    if (patch->arc) {
        double angle = x;
        x = patch->centre[0] + patch->radius * cos(angle);
        y = patch->centre[1] + patch->radius * sin(angle);
    }
    double turn = 2.0 * MIRROR_PI * v;
    return d3(x * cos(turn), y, x * sin(turn));
}

// The squared distance from p to a piece. Start at the nearest point of a grid, which has no point
// on the axis, and step towards any point that is nearer; the step is halved whenever no point is
// nearer. The remaining error is less than the last step.
static double patch_distance(const struct patch *patch, struct d3 p)
{
    double best = HUGE_VAL, u = 0.0, v = 0.0;
    for (int i = 0; i < SOLID_GRID; i++)
        for (int j = 0; j < SOLID_GRID; j++) {
            struct d3 to = d3_sub(patch->grid[i][j], p);
            double square = d3_dot(to, to);
            if (square < best) {
                best = square;
                u = (i + 0.5) / SOLID_GRID;
                v = (j + 0.5) / SOLID_GRID;
            }
        }
    for (double step = 0.5 / SOLID_GRID; step > 1e-7;) {
        bool moved = false;
        for (int way = 0; way < 4; way++) {
            double a = mirror_clamp(u + (way == 0 ? step : way == 1 ? -step : 0.0));
            double b = v + (way == 2 ? step : way == 3 ? -step : 0.0);
            b = patch->turned ? b : mirror_clamp(b);
            struct d3 to = d3_sub(patch_at(patch, a, b), p);
            double square = d3_dot(to, to);
            // On the axis, every v gives the same point, up to rounding.
            if (square < best * (1.0 - 1e-12)) {
                best = square;
                u = a;
                v = b;
                moved = true;
            }
        }
        step *= moved ? 1.0 : 0.5;
    }
    return best;
}

static struct patch *add(struct solid *solid)
{
    assert_true(solid->count < SOLID_MOST);
    return &solid->patch[solid->count++];
}

void solid_add_flat(struct solid *solid, struct d3 origin, struct d3 side, struct d3 other)
{
    *add(solid) = (struct patch){.origin = origin, .side = side, .other = other};
}

void solid_add_turned(struct solid *solid, double x0, double y0, double x1, double y1)
{
    *add(solid) = (struct patch){.turned = true, .from = {x0, y0}, .to = {x1, y1}};
}

void solid_add_turned_circle(struct solid *solid, double x, double radius)
{
    double end = x >= radius ? MIRROR_PI : acos(-x / radius);
    *add(solid) = (struct patch){.turned = true,
                                 .arc = true,
                                 .centre = {x, 0.0},
                                 .radius = radius,
                                 .from = {-end, 0.0},
                                 .to = {end, 0.0}};
}

static void fill_grids(struct solid *solid)
{
    for (int k = 0; k < solid->count; k++)
        for (int i = 0; i < SOLID_GRID; i++)
            for (int j = 0; j < SOLID_GRID; j++)
                solid->patch[k].grid[i][j] =
                    patch_at(&solid->patch[k], (i + 0.5) / SOLID_GRID, (j + 0.5) / SOLID_GRID);
}

static double truth(const struct solid *solid, struct d3 p)
{
    double square = HUGE_VAL;
    for (int k = 0; k < solid->count; k++)
        square = fmin(square, patch_distance(&solid->patch[k], p));
    if (solid->thickness > 0.0)
        return sqrt(square) - solid->thickness;
    return solid->inside(solid, p) ? -sqrt(square) : sqrt(square);
}

// ---- The distances compared with the surface ----

float *solid_call(const struct solid *solid)
{
    return gpu_call(SHADER, WIDE * SOLID_SLOTS, ROWS, solid->function, solid->number);
}

double solid_slack(struct d3 p)
{
    return 8.0 * MIRROR_FLOAT_ROUNDING * (d3_length(p) + 2.0) + 1e-8;
}

static void check_point(const struct solid *solid, const float *slot, struct tally *tally)
{
    struct d3 p = d3_of(slot), q = d3_of(slot + 4);
    double f = (double)slot[3], d = truth(solid, p), slack = solid_slack(p);
    bool outside = d > 0.0, exact = outside ? solid->exact_outside : solid->exact_inside;
    if (exact)
        tally->worst = fmax(tally->worst, fabs(f - d) / slack);
    // The value must be a lower bound on either side and have the right sign.
    assert_true(outside ? f >= -slack && f <= d + slack : f <= slack && f >= d - slack);
    if (fabs(d) > 0.01)
        tally->least[outside] = fmin(tally->least[outside], f / d);
    tally->inside += !outside;
    tally->outside += outside;
    double apart = d3_length(d3_sub(p, q)), change = fabs(f - (double)slot[7]);
    assert_true(change <= apart + slack + solid_slack(q));
    if (apart > 0.01)
        tally->steepest = fmax(tally->steepest, change / apart);
}

struct tally solid_check(struct solid *solid)
{
    struct tally tally = {.least = {HUGE_VAL, HUGE_VAL}};
    fill_grids(solid);
    float *values = solid_call(solid);
    for (int i = 0; i < SOLID_ITEMS; i++)
        check_point(solid, values + (size_t)4 * SOLID_SLOTS * (size_t)i, &tally);
    free(values);
    print_message("# %s: %d outside, f/d from %.4f; %d inside, from %.4f; worst error %.2f times "
                  "the allowed error; steepest slope %.4f\n",
                  solid->name, tally.outside, tally.least[1], tally.inside, tally.least[0],
                  tally.worst, tally.steepest);
    assert_true(tally.inside > 20 && tally.outside > 500 && tally.worst <= 1.0);
    assert_true(tally.steepest > 0.98);
    return tally;
}

bool solid_never(const struct solid *solid, struct d3 p)
{
    (void)solid, (void)p;
    return false;
}
