#include "sweep.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "memory.h"

// The points of a grid, with one extra layer around them. The distances in the layer are infinite.
struct grid {
    double *value;       // as given; the outer layer repeats the points beside it
    double *distance;    // unsigned
    bool *fixed;         // kept, or next to the surface, or in the outer layer
    int size[3];         // without the layer
    ptrdiff_t stride[3]; // from a point to its neighbour on each axis
    double cell;
    bool keeps; // true if the values next to the surface are kept too
};

static double least_of(double a, double b)
{
    return a < b ? a : b;
}

static double most_of(double a, double b)
{
    return a > b ? a : b;
}

static ptrdiff_t index_of(const struct grid *grid, int x, int y, int z)
{
    return (x + 1) + (y + 1) * grid->stride[1] + (z + 1) * grid->stride[2];
}

// The distance from a point to the nearer of the surface's crossings with its two edges along an
// axis; INFINITY if both neighbours have the point's sign.
static double to_crossing(const struct grid *grid, ptrdiff_t i, int axis)
{
    double here = grid->value[i], nearest = INFINITY;
    for (int side = -1; side <= 1; side += 2) {
        double there = grid->value[i + side * grid->stride[axis]];
        if ((here < 0.0) != (there < 0.0))
            nearest = least_of(nearest, grid->cell * here / (here - there));
    }
    return nearest;
}

// Set the distance of a point that is next to the surface: the distance to the plane that cuts the
// axes at the crossings or, if values are kept, the value. For any other point, set INFINITY.
//   formula  1 / sqrt(1 / a^2 + 1 / b^2 + 1 / c^2), with the distances a, b, c to the crossings
static void begin(struct grid *grid, ptrdiff_t i)
{
    double sum = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        double way = to_crossing(grid, i, axis);
        if (way < INFINITY) {
            grid->fixed[i] = true;
            sum += 1.0 / most_of(way * way, 1e-30);
        }
    }
    double beside = grid->keeps ? fabs(grid->value[i]) : 1.0 / sqrt(sum);
    grid->distance[i] = grid->fixed[i] ? beside : INFINITY;
}

// The solution d of (d - a)^2 + (d - b)^2 + (d - c)^2 = cell^2 that is above a, b and c. A term is
// left out if its a, b or c would be above d.
static double solve(double a, double b, double c, double cell)
{
    double least = least_of(a, least_of(b, c)), most = most_of(a, most_of(b, c));
    double middle = most_of(least_of(a, b), least_of(most_of(a, b), c));
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

// Solve for a point from the smaller of its two neighbours on each axis.
static void relax(struct grid *grid, ptrdiff_t i)
{
    const double *here = &grid->distance[i];
    const ptrdiff_t *stride = grid->stride;
    double a = least_of(here[-stride[0]], here[stride[0]]);
    double b = least_of(here[-stride[1]], here[stride[1]]);
    double c = least_of(here[-stride[2]], here[stride[2]]);
    grid->distance[i] = least_of(*here, solve(a, b, c, grid->cell));
}

// Visit all points, upwards or downwards on each axis according to a bit of order.
static void sweep(struct grid *grid, int order)
{
    const int *size = grid->size;
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            for (int x = 0; x < size[0]; x++) {
                ptrdiff_t i =
                    index_of(grid, order & 1 ? size[0] - 1 - x : x, order & 2 ? size[1] - 1 - y : y,
                             order & 4 ? size[2] - 1 - z : z);
                if (!grid->fixed[i])
                    relax(grid, i);
            }
}

// Copy the values, and mark those that are kept.
static void open_grid(struct grid *grid, const double *value, const bool *keep, const int size[3],
                      double cell)
{
    ptrdiff_t row = size[0] + 2, slice = row * (size[1] + 2), count = slice * (size[2] + 2);
    *grid = (struct grid){.value = memory_zeros((size_t)count, sizeof(double)),
                          .distance = memory_zeros((size_t)count, sizeof(double)),
                          .fixed = memory_zeros((size_t)count, sizeof(bool)),
                          .size = {size[0], size[1], size[2]},
                          .stride = {1, row, slice},
                          .cell = cell,
                          .keeps = keep != NULL};
    for (ptrdiff_t i = 0; i < count; i++) {
        const int padded[3] = {(int)(i % row), (int)(i / row % (size[1] + 2)), (int)(i / slice)};
        int at[3];
        bool inner = true;
        for (int k = 0; k < 3; k++) {
            at[k] = padded[k] < 1 ? 0 : padded[k] > size[k] ? size[k] - 1 : padded[k] - 1;
            inner = inner && at[k] == padded[k] - 1;
        }
        int from = at[0] + size[0] * (at[1] + size[1] * at[2]);
        bool kept = inner && keep != NULL && keep[from];
        grid->value[i] = value[from];
        grid->distance[i] = kept ? fabs(value[from]) : INFINITY;
        grid->fixed[i] = kept || !inner;
    }
}

void sweep_distances(double *value, const bool *keep, const int size[3], double cell)
{
    struct grid grid;
    open_grid(&grid, value, keep, size, cell);
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            for (int x = 0; x < size[0]; x++) {
                ptrdiff_t i = index_of(&grid, x, y, z);
                if (!grid.fixed[i])
                    begin(&grid, i);
            }
    for (int order = 0; order < 8; order++)
        sweep(&grid, order);
    for (int i = 0; i < size[0] * size[1] * size[2]; i++) {
        double distance = grid.distance[index_of(&grid, i % size[0], i / size[0] % size[1],
                                                 i / (size[0] * size[1]))];
        if (distance < INFINITY)
            value[i] = value[i] < 0.0 ? -distance : distance;
    }
    free(grid.value);
    free(grid.distance);
    free(grid.fixed);
}
