// The marches of chapters/experiments/16_marches.glsl and the scenes of 16_stress.frag in double
// precision.
#include "lib/marches.h"

#define TORUS  1.3
#define TUBE   0.01
#define GROUND 0.9
#define BEAM   0.02

static const double apart = 0.2;
static const struct d3 cube = {0.8, 0.8, 0.8}, plate = {1.0, 0.002, 1.0};

static struct d3 cube_point(struct d3 p)
{
    return d3(0.8 * p.x + 0.6 * p.z, p.y, 0.8 * p.z - 0.6 * p.x);
}

double march_stress_distance(int stress, struct d3 p)
{
    double nearest = 1e9;
    if (stress == 0)
        return hypot(hypot(p.x, p.z) - TORUS, p.y) - TUBE;
    if (stress == 1)
        return p.y - GROUND;
    if (stress == 2)
        return mirror_box_frame(cube_point(p), cube, BEAM);
    for (int i = -4; i <= 4; i++)
        nearest = fmin(nearest, mirror_box(d3(p.x, p.y - apart * i, p.z), plate));
    return nearest;
}

// ---- The bounds of the slope: -d'(t) at the start, from differences, for one convex body ----

static double box_fall(struct d3 p, struct d3 v, struct d3 half)
{
    const double h = 1e-6;
    return (mirror_box(d3_sub(p, d3_times(h, v)), half) -
            mirror_box(d3_add(p, d3_times(h, v)), half)) /
           (2.0 * h);
}

static double torus_fall(struct d3 p, struct d3 v, double reach)
{
    const double h = 1e-6;
    double rate = (march_stress_distance(0, d3_sub(p, d3_times(h, v))) -
                   march_stress_distance(0, d3_add(p, d3_times(h, v)))) /
                  (2.0 * h);
    double q = hypot(p.x, p.z), from_circle = hypot(q - TORUS, p.y);
    double least = fmax(q - reach * hypot(v.x, v.z), 1e-6),
           nearest = fmax(from_circle - reach, TUBE);
    return rate + reach * fmax(TORUS - least, 0.0) / (least * nearest);
}

static double cube_fall(struct d3 p, struct d3 v)
{
    struct d3 q = cube_point(p), u = cube_point(v);
    double fall = -1.0, side = cube.x - BEAM;
    for (int axis = 0; axis < 3; axis++)
        for (int corner = 0; corner < 4; corner++) {
            double a = corner & 1 ? side : -side, b = corner & 2 ? side : -side;
            struct d3 middle = axis == 0   ? d3(0.0, a, b)
                               : axis == 1 ? d3(a, 0.0, b)
                                           : d3(a, b, 0.0);
            struct d3 half = axis == 0   ? d3(cube.x, BEAM, BEAM)
                             : axis == 1 ? d3(BEAM, cube.x, BEAM)
                                         : d3(BEAM, BEAM, cube.x);
            fall = fmax(fall, box_fall(d3_sub(q, middle), u, half));
        }
    return fall;
}

static double fall_along(int stress, struct d3 p, struct d3 v, double reach)
{
    double fall = -1.0;
    if (stress == 0)
        return torus_fall(p, v, reach);
    if (stress == 1)
        return -v.y;
    if (stress == 2)
        return cube_fall(p, v);
    for (int i = -4; i <= 4; i++)
        fall = fmax(fall, box_fall(d3(p.x, p.y - apart * i, p.z), v, plate));
    return fall;
}

// ---- The marches ----

enum { STEPS = 4096 };

struct state {
    int stress;
    struct mirror_ray ray;
    double far, threshold;
    int steps;
};

static double ask(struct state *state, double t)
{
    state->steps++;
    return march_stress_distance(state->stress, mirror_at(state->ray, t));
}

static struct mirror_march ended(const struct state *state, bool found, double t)
{
    return (struct mirror_march){.t = t,
                                 .steps = state->steps,
                                 .end = found             ? MIRROR_HIT
                                        : t >= state->far ? MIRROR_PASSED
                                                          : MIRROR_GAVE_UP};
}

// The plain march, with a threshold that may grow along the ray.
static struct mirror_march plain(struct state *state, double spread)
{
    double t = 0.0;
    while (t < state->far && state->steps < STEPS) {
        double d = ask(state, t);
        if (d < state->threshold + spread * t)
            return ended(state, true, t);
        t += d;
    }
    return ended(state, false, t);
}

// Marches that look ahead of the covered part of the ray. With slopes, the length of a step comes
// from the last two distances that were used. Otherwise, a step is omega times the distance and,
// after the first step back, only the distance.
static struct mirror_march ahead(struct state *state, bool slopes, double omega)
{
    double covered = 0.0, t = 0.0, at = 0.0, before = 0.0;
    while (covered < state->far && state->steps < STEPS) {
        double d = ask(state, t);
        if (t > covered && t - d > covered) {
            omega = slopes ? omega : 1.0;
            t = covered;
            continue;
        }
        if (d < state->threshold && t < state->far)
            return ended(state, true, t);
        double slope = t > at ? fmin(fmax((before - d) / (t - at), -0.9), 1.0) : 1.0;
        double advance = slopes ? d + omega * d * (1.0 - slope) / (1.0 + slope) : omega * d;
        before = d;
        at = t;
        covered = t + d;
        t = fmin(t + advance, state->far);
    }
    return ended(state, false, covered);
}

static struct mirror_march segment(struct state *state)
{
    double t = 0.0, reach = state->far;
    while (t < state->far && state->steps < STEPS) {
        double d = ask(state, t);
        if (d < state->threshold)
            return ended(state, true, t);
        double fall =
            fall_along(state->stress, mirror_at(state->ray, t), state->ray.direction, reach);
        double advance = fmin(d / fmin(fmax(fall, 1e-6), 1.0), reach);
        t += advance;
        reach = fmax(fmin(2.0 * advance, state->far - t), 1e-6);
    }
    return ended(state, false, t);
}

static struct mirror_march overstep(struct state *state, double omega)
{
    double t = 0.0, outside = 0.0, inside = HUGE_VAL;
    while (t < state->far && state->steps < STEPS) {
        double d = ask(state, t);
        if (d < state->threshold && (d >= 0.0 || t == 0.0))
            return ended(state, true, t);
        *(d < 0.0 ? &inside : &outside) = t;
        t = inside < HUGE_VAL ? 0.5 * (outside + inside) : t + omega * d;
    }
    return ended(state, false, t);
}

struct mirror_march march_in_double(int stress, enum march_kind kind, struct mirror_ray ray,
                                    double far, double threshold, double spread)
{
    struct state state = {.stress = stress, .ray = ray, .far = far, .threshold = threshold};
    switch (kind) {
    case MARCH_RELAXED:
        return ahead(&state, false, 1.2);
    case MARCH_ENHANCED:
        return ahead(&state, true, 0.9);
    case MARCH_SEGMENT:
        return segment(&state);
    case MARCH_OVERSTEP:
        return overstep(&state, 1.5);
    default:
        return plain(&state, kind == MARCH_CONE ? spread : 0.0);
    }
}
