#include "parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const double part_low[3] = {-10.0, -2.0, -16.0};

static double minimum(double a, double b)
{
    return a < b ? a : b;
}

static double maximum(double a, double b)
{
    return a > b ? a : b;
}

// ---- A part ----

double part_distance(const struct part *part, const double p[3])
{
    double along = 0.0, square = 0.0, apart = 0.0;
    for (int i = 0; i < 3; i++) {
        along += (p[i] - part->centre[i]) * part->half[i];
        square += part->half[i] * part->half[i];
    }
    double h = minimum(maximum(along / maximum(square, 1e-9), -1.0), 1.0);
    for (int i = 0; i < 3; i++) {
        double d = p[i] - part->centre[i] - h * part->half[i];
        apart += d * d;
    }
    return sqrt(apart) - part->radius;
}

// The square of the distance between the point of a part's segment at h and a cube.
static double square_at(const struct part *part, double h, const double centre[3], double half)
{
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        double at = part->centre[i] + h * part->half[i] - centre[i];
        double outside = maximum((at < 0.0 ? -at : at) - half, 0.0);
        square += outside * outside;
    }
    return square;
}

double part_distance_from_cube(const struct part *part, const double centre[3], double half)
{
    double low = -1.0, high = 1.0; // the square is a convex function of h: divide the range
    for (int i = 0; i < 40; i++) {
        double third = (high - low) / 3.0, a = low + third, b = high - third;
        if (square_at(part, a, centre, half) < square_at(part, b, centre, half))
            high = b;
        else
            low = a;
    }
    return sqrt(square_at(part, 0.5 * (low + high), centre, half)) - part->radius - 1e-5;
}

double part_union(double a, double b, double blend)
{
    double h = maximum(blend - fabs(a - b), 0.0);
    return minimum(a, b) - h * h * h / (6.0 * blend * blend);
}

double parts_distance(const struct part *part, const uint16_t *id, int count, double blend,
                      const double p[3])
{
    double value = 1e9;
    for (int i = 0; i < count; i++)
        value = part_union(value, part_distance(&part[id != NULL ? id[i] : i], p), blend);
    return value;
}

static double stored(double value, double unit, double most)
{
    return unit * minimum(maximum(floor(value / unit + 0.5), 0.0), most);
}

struct part part_stored(struct part part)
{
    for (int i = 0; i < 3; i++) {
        double from = part.centre[i] - part_low[i], half = part.half[i] + 128.0 * PART_HALF;
        part.centre[i] = part_low[i] + stored(from, PART_COORDINATE, 65535.0);
        part.half[i] = stored(half, PART_HALF, 255.0) - 128.0 * PART_HALF;
    }
    double root = stored(sqrt(part.radius / PART_RADIUS), 1.0, 255.0);
    part.radius = PART_RADIUS * root * root;
    return part;
}

// ---- The grid ----

// A box of cells and the parts that may matter in it.
struct block {
    int low[3], high[3];
    uint16_t *id;
    double *distance; // distances of the parts from the centre
    int count;
};

struct builder {
    struct part_grid *grid;
    const struct part *part;
    int room; // capacity of grid->id
    bool failed;
};

// Keep only the parts whose distance from the centre of a box of radius r exceeds the smallest such
// distance by less than PART_REACH times the blend plus 2 r. Returns the scene's distance from the
// centre.
static double prune(const struct builder *b, struct block *block, const double centre[3], double r)
{
    double least = 1e9, value = 1e9;
    for (int i = 0; i < block->count; i++) {
        block->distance[i] = part_distance(&b->part[block->id[i]], centre);
        least = minimum(least, block->distance[i]);
    }
    b->grid->tests += block->count;
    int kept = 0;
    for (int i = 0; i < block->count; i++)
        if (block->distance[i] < least + PART_REACH * b->grid->blend + 2.0 * r) {
            value = part_union(value, block->distance[i], b->grid->blend);
            block->distance[kept] = block->distance[i];
            block->id[kept++] = block->id[i];
        }
    block->count = kept;
    return value;
}

// Shorten the list of a cell, and store it.
//   value   the scene's distance from the centre
//   r       the corners' distance from the centre
static void finish(struct builder *b, struct block *block, const double centre[3], double value,
                   double r)
{
    struct part_grid *grid = b->grid;
    int kept = 0, nearest = 0;
    for (int i = 1; i < block->count; i++)
        nearest = block->distance[i] < block->distance[nearest] ? i : nearest;
    bool solid = value < -r; // no march gets here, so the nearest part is enough
    for (int i = 0; i < block->count; i++)
        if (solid ? i == nearest
                  : block->distance[i] - r < PART_MARGIN * grid->blend &&
                        part_distance_from_cube(&b->part[block->id[i]], centre, 0.5 * grid->size) <
                            PART_MARGIN * grid->blend)
            block->id[kept++] = block->id[i];
    if (grid->ids + kept > b->room) {
        b->room = 2 * (grid->ids + kept) + 1024;
        uint16_t *larger = realloc(grid->id, (size_t)b->room * sizeof *larger);
        if (larger == NULL) {
            b->failed = true;
            return;
        }
        grid->id = larger;
    }
    if (kept > 0)
        memcpy(grid->id + grid->ids, block->id, (size_t)kept * sizeof *grid->id);
    int at = (block->low[2] * grid->cells[1] + block->low[1]) * grid->cells[0] + block->low[0];
    grid->cell[at] = (struct part_cell){grid->ids, kept, value};
    grid->ids += kept;
    grid->most = kept > grid->most ? kept : grid->most;
}

// Select one eighth of a box of cells. Returns false if the eighth has no cells.
static bool eighth(const struct block *block, int number, struct block *part)
{
    bool any = true;
    for (int i = 0; i < 3; i++) {
        int middle = block->low[i] + (block->high[i] - block->low[i] + 1) / 2;
        part->low[i] = number >> i & 1 ? middle : block->low[i];
        part->high[i] = number >> i & 1 ? block->high[i] : middle;
        any &= part->low[i] < part->high[i];
    }
    return any;
}

// Prune the list of a box for each of its eighths, down to single cells.
static void divide(struct builder *b, const struct block *box, const uint16_t *id, int count)
{
    struct block block = *box;
    block.count = count;
    block.id = malloc(((size_t)count + 1) * sizeof *block.id);
    block.distance = malloc(((size_t)count + 1) * sizeof *block.distance);
    b->failed |= block.id == NULL || block.distance == NULL;
    if (!b->failed) {
        double centre[3], square = 0.0;
        memcpy(block.id, id, (size_t)count * sizeof *id);
        for (int i = 0; i < 3; i++) {
            double side = b->grid->size * (box->high[i] - box->low[i]);
            centre[i] = b->grid->low[i] + 0.5 * b->grid->size * (box->high[i] + box->low[i]);
            square += 0.25 * side * side;
        }
        double r = sqrt(square) + 1e-4, value = prune(b, &block, centre, r);
        struct block part;
        bool one = true;
        for (int i = 0; i < 3; i++)
            one &= block.high[i] - block.low[i] == 1;
        if (one)
            finish(b, &block, centre, value, r);
        for (int number = 0; !one && number < 8; number++)
            if (eighth(&block, number, &part))
                divide(b, &part, block.id, block.count);
    }
    free(block.id);
    free(block.distance);
}

// Set the corner of the grid and the size and number of its cells. The grid contains all parts and
// the material that their blends add.
static void surround(struct part_grid *grid, const struct part *part, int count, double fineness)
{
    double high[3], longest = 0.0, root = 1.0;
    for (int i = 0; i < 3; i++) {
        grid->low[i] = 1e9;
        high[i] = -1e9;
        for (int k = 0; k < count; k++) {
            double reach = fabs(part[k].half[i]) + part[k].radius + grid->blend;
            grid->low[i] = minimum(grid->low[i], part[k].centre[i] - reach);
            high[i] = maximum(high[i], part[k].centre[i] + reach);
        }
        grid->low[i] = floor(64.0 * grid->low[i]) / 64.0;
        longest = maximum(longest, high[i] - grid->low[i]);
    }
    for (int i = 0; i < 40; i++) // Newton's method for the cube root
        root = (2.0 * root + count / (root * root)) / 3.0;
    grid->size = ceil(4096.0 * longest / (fineness * root)) / 4096.0;
    for (int i = 0; i < 3; i++)
        grid->cells[i] = (int)ceil((high[i] - grid->low[i]) / grid->size);
}

bool part_grid_build(struct part_grid *grid, const struct part *part, int count, double blend,
                     double fineness)
{
    *grid = (struct part_grid){.blend = blend};
    surround(grid, part, count, fineness);
    struct builder b = {.grid = grid, .part = part};
    struct block all = {.high = {grid->cells[0], grid->cells[1], grid->cells[2]}};
    grid->cell = calloc((size_t)grid->cells[0] * (size_t)grid->cells[1] * (size_t)grid->cells[2],
                        sizeof *grid->cell);
    uint16_t *id = malloc((size_t)count * sizeof *id);
    b.failed = grid->cell == NULL || id == NULL;
    for (int i = 0; !b.failed && i < count; i++)
        id[i] = (uint16_t)i;
    if (!b.failed)
        divide(&b, &all, id, count);
    free(id);
    if (b.failed)
        part_grid_free(grid);
    return !b.failed;
}

void part_grid_free(struct part_grid *grid)
{
    free(grid->cell);
    free(grid->id);
    *grid = (struct part_grid){0};
}

const struct part_cell *part_grid_cell(const struct part_grid *grid, const double p[3])
{
    int at[3];
    for (int i = 0; i < 3; i++) {
        double index = floor((p[i] - grid->low[i]) / grid->size);
        at[i] = (int)minimum(maximum(index, 0.0), grid->cells[i] - 1.0);
    }
    return &grid->cell[(at[2] * grid->cells[1] + at[1]) * grid->cells[0] + at[0]];
}
