#include "sculpt.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "elephant.h"
#include "memory.h"
#include "sweep.h"

enum { SIDE = ELEPHANT_SIDE };

static const double cell = 2.0 / (SIDE - 1);

// ---- Reading the grid ----

static double value_at(const unsigned char *grid, int x, int y, int z)
{
    const unsigned char *byte = grid + SCULPT_BYTES * (x + SIDE * (y + SIDE * z));
    return (2.0 * (256 * byte[0] + byte[1]) / 65535.0 - 1.0) * ELEPHANT_RANGE;
}

static double mix(double a, double b, double share)
{
    return a + share * (b - a);
}

double sculpt_value(const unsigned char *grid, const double p[3])
{
    int low[3];
    double share[3], outside = 0.0, line[4];
    for (int i = 0; i < 3; i++) {
        double q = fmin(fmax(p[i], -1.0), 1.0), position = (q + 1.0) / cell;
        low[i] = (int)fmin(position, SIDE - 2.0);
        share[i] = position - low[i];
        outside += (p[i] - q) * (p[i] - q);
    }
    for (int k = 0; k < 4; k++) {
        int y = low[1] + k % 2, z = low[2] + k / 2;
        line[k] = mix(value_at(grid, low[0], y, z), value_at(grid, low[0] + 1, y, z), share[0]);
    }
    double value = mix(mix(line[0], line[1], share[1]), mix(line[2], line[3], share[1]), share[2]);
    return outside > 0.0 ? sqrt(outside + value * value) : value;
}

bool sculpt_march(const unsigned char *grid, const double origin[3], const double direction[3],
                  double hit[3])
{
    double t = 0.0;
    for (int step = 0; step < 1000 && t < 20.0; step++) {
        for (int i = 0; i < 3; i++)
            hit[i] = origin[i] + t * direction[i];
        double value = sculpt_value(grid, hit);
        if (value < 0.0001)
            return true;
        t += fmax(0.577 * value, value - 1.733 * cell);
    }
    return false;
}

// ---- Changing the grid ----

// The distance from p to a roll of clay.
static double to_roll(const double p[3], const double from[3], const double to[3], double radius)
{
    double along = 0.0, squared = 0.0, apart = 0.0;
    for (int i = 0; i < 3; i++) {
        along += (p[i] - from[i]) * (to[i] - from[i]);
        squared += (to[i] - from[i]) * (to[i] - from[i]);
    }
    double share = squared > 0.0 ? fmin(fmax(along / squared, 0.0), 1.0) : 0.0;
    for (int i = 0; i < 3; i++) {
        double way = p[i] - mix(from[i], to[i], share);
        apart += way * way;
    }
    return sqrt(apart) - radius;
}

// A lower bound of the distance from p to a roll that is cut off before it leaves the grid.
static double to_cut_roll(const double p[3], const double from[3], const double to[3],
                          double radius)
{
    double farthest = fmax(fabs(p[0]), fmax(fabs(p[1]), fabs(p[2])));
    return fmax(to_roll(p, from, to, radius), farthest - SCULPT_REACH);
}

// opSmoothUnionQuadratic of shaders/combine.glsl.
static double smooth_union(double a, double b)
{
    double overlap = fmax(SCULPT_BLEND - fabs(a - b), 0.0);
    return fmin(a, b) - 0.25 * overlap * overlap / SCULPT_BLEND;
}

// Find the part of the grid that a piece may change: low is its first point, size the number of
// points on each axis. Returns false if no part may change.
static bool find_box(const double from[3], const double to[3], double radius, int low[3],
                     int size[3])
{
    double reach = radius + ELEPHANT_RANGE + SCULPT_BLEND;
    for (int i = 0; i < 3; i++) {
        double first = (fmin(from[i], to[i]) - reach + 1.0) / cell;
        double last = (fmax(from[i], to[i]) + reach + 1.0) / cell;
        if (!(last >= 1.0 && first <= SIDE - 2.0))
            return false;
        low[i] = (int)fmax(floor(first), 0.0);
        size[i] = (int)fmin(ceil(last), SIDE - 1.0) - low[i] + 1;
    }
    return true;
}

// The box of a piece, and the values in it.
struct box {
    int low[3], size[3];
    double *value;
    bool *keep;
};

// Blend the piece into the values of the box.
static void blend(struct box *box, const unsigned char *grid, const unsigned char *before,
                  const double from[3], const double to[3], double radius)
{
    double side = radius < 0.0 ? -1.0 : 1.0;
    size_t i = 0;
    for (int z = box->low[2]; z < box->low[2] + box->size[2]; z++)
        for (int y = box->low[1]; y < box->low[1] + box->size[1]; y++)
            for (int x = box->low[0]; x < box->low[0] + box->size[0]; x++, i++) {
                const double p[3] = {elephant_coordinate(x), elephant_coordinate(y),
                                     elephant_coordinate(z)};
                double now = value_at(grid, x, y, z);
                double roll =
                    radius < 0.0 ? to_roll(p, from, to, -radius) : to_cut_roll(p, from, to, radius);
                double then = smooth_union(side * value_at(before, x, y, z), roll);
                box->keep[i] = roll >= fabs(now) + SCULPT_BLEND;
                box->value[i] = box->keep[i] ? now : side * fmin(side * now, then);
            }
}

// Write the values back, except those that were kept.
static void store(const struct box *box, unsigned char *grid)
{
    const int *size = box->size;
    for (int i = 0; i < size[0] * size[1] * size[2]; i++) {
        int x = box->low[0] + i % size[0], y = box->low[1] + i / size[0] % size[1];
        int z = box->low[2] + i / (size[0] * size[1]);
        if (!box->keep[i])
            elephant_encode(box->value[i], grid + SCULPT_BYTES * (x + SIDE * (y + SIDE * z)));
    }
}

void sculpt_piece(unsigned char *grid, const unsigned char *before, const double from[3],
                  const double to[3], double radius, int slices[2])
{
    struct box box = {.value = NULL};
    slices[0] = slices[1] = 0;
    if (!find_box(from, to, fabs(radius), box.low, box.size))
        return;
    size_t count = (size_t)box.size[0] * (size_t)box.size[1] * (size_t)box.size[2];
    box.value = memory_zeros(count, sizeof *box.value);
    box.keep = memory_zeros(count, sizeof *box.keep);
    blend(&box, grid, before, from, to, radius);
    sweep_distances(box.value, box.keep, box.size, cell);
    store(&box, grid);
    slices[0] = box.low[2];
    slices[1] = box.low[2] + box.size[2];
    free(box.value);
    free(box.keep);
}
