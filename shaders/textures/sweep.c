#include "sweep.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "mesh.h"

struct grid {
    const double *value; // as given
    double *distance;    // without sign
    bool *fixed;         // next to the surface
    int side;
    double cell;
};

static size_t index_of(const struct grid *grid, const int at[3])
{
    size_t side = (size_t)grid->side;
    return (size_t)at[0] + side * ((size_t)at[1] + side * (size_t)at[2]);
}

// The distance from a point to the nearer crossing of the surface with its two edges along an axis;
// INFINITY if both neighbours have its sign.
static double to_crossing(const struct grid *grid, const int at[3], int axis)
{
    double here = grid->value[index_of(grid, at)], nearest = INFINITY;
    for (int side = -1; side <= 1; side += 2) {
        int beside[3] = {at[0], at[1], at[2]};
        beside[axis] += side;
        if (beside[axis] < 0 || beside[axis] >= grid->side)
            continue;
        double there = grid->value[index_of(grid, beside)];
        if ((here < 0.0) != (there < 0.0))
            nearest = fmin(nearest, grid->cell * here / (here - there));
    }
    return nearest;
}

// Next to the surface: the distance to the plane that cuts the axes at the crossings.
//   formula  1 / sqrt(1 / a^2 + 1 / b^2 + 1 / c^2), a, b, c the distances to the crossings
static void begin(struct grid *grid, const int at[3])
{
    size_t i = index_of(grid, at);
    double sum = 0.0;
    grid->distance[i] = INFINITY;
    for (int axis = 0; axis < 3; axis++) {
        double way = to_crossing(grid, at, axis);
        if (way < INFINITY) {
            grid->fixed[i] = true;
            sum += 1.0 / fmax(way * way, 1e-30);
        }
    }
    if (grid->fixed[i])
        grid->distance[i] = 1.0 / sqrt(sum);
}

// The smaller distance of the two neighbours along an axis.
static double upwind(const struct grid *grid, const int at[3], int axis)
{
    double least = INFINITY;
    for (int side = -1; side <= 1; side += 2) {
        int beside[3] = {at[0], at[1], at[2]};
        beside[axis] += side;
        if (beside[axis] >= 0 && beside[axis] < grid->side)
            least = fmin(least, grid->distance[index_of(grid, beside)]);
    }
    return least;
}

// The solution d of (d - a)^2 + (d - b)^2 + (d - c)^2 = cell^2, where a term counts only if d is
// greater than its a, b or c.
static double solve(double a, double b, double c, double cell)
{
    double least = fmin(a, fmin(b, c)), most = fmax(a, fmax(b, c));
    double middle = fmax(fmin(a, b), fmin(fmax(a, b), c));
    double d = least + cell;
    if (d > middle) {
        double apart = middle - least;
        d = 0.5 * (least + middle + sqrt(2.0 * cell * cell - apart * apart));
    }
    if (d > most) {
        double sum = a + b + c, squares = a * a + b * b + c * c;
        d = (sum + sqrt(sum * sum - 3.0 * (squares - cell * cell))) / 3.0;
    }
    return d;
}

// Visit all points, along each axis upwards or downwards; bit k of the order is set if axis k goes
// downwards.
static void sweep(struct grid *grid, int order)
{
    int last = grid->side - 1;
    for (int z = 0; z <= last; z++)
        for (int y = 0; y <= last; y++)
            for (int x = 0; x <= last; x++) {
                const int at[3] = {order & 1 ? last - x : x, order & 2 ? last - y : y,
                                   order & 4 ? last - z : z};
                size_t i = index_of(grid, at);
                double a = upwind(grid, at, 0), b = upwind(grid, at, 1), c = upwind(grid, at, 2);
                if (!grid->fixed[i] && fmin(a, fmin(b, c)) < INFINITY)
                    grid->distance[i] = fmin(grid->distance[i], solve(a, b, c, grid->cell));
            }
}

void sweep_distances(double *value, int side, double cell)
{
    size_t count = (size_t)side * (size_t)side * (size_t)side;
    struct grid grid = {value, mesh_memory(count, sizeof(double)), mesh_memory(count, sizeof(bool)),
                        side, cell};
    for (size_t i = 0; i < count; i++) {
        size_t s = (size_t)side;
        const int at[3] = {(int)(i % s), (int)(i / s % s), (int)(i / s / s)};
        begin(&grid, at);
    }
    for (int order = 0; order < 16; order++)
        sweep(&grid, order % 8);
    for (size_t i = 0; i < count; i++)
        if (grid.distance[i] < INFINITY)
            value[i] = value[i] < 0.0 ? -grid.distance[i] : grid.distance[i];
    free(grid.distance);
    free(grid.fixed);
}
