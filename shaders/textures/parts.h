// parts.h - a scene of thousands of parts that blend where they meet, and a grid that lists the
// parts that matter in each cell. Chapter 22 explains both.
//
// A part is a capsule: the points within its radius of a segment. Lengths are in scene units.
#ifndef PARTS_H
#define PARTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define PART_COORDINATE (1.0 / 2048.0)  // positions are multiples of this
#define PART_HALF       (1.0 / 256.0)   // half segments are multiples of this
#define PART_RADIUS     (1.0 / 65536.0) // radii are squares of whole numbers times this

// A part is left out of a cell's list only if, at every point of the cell, it is farther away than
// the nearest part by at least PART_REACH times the blend, or is at least PART_MARGIN times the
// blend away. The exception is a cell that lies inside the scene, which lists only one part.
#define PART_REACH  3.0
#define PART_MARGIN 3.0

#define PART_FINENESS 9.6 // fineness of the chapter's grid, for part_grid_build

// The corner of the scene from which positions are measured.
extern const double part_low[3];

struct part {
    double centre[3], half[3]; // the segment is from centre - half to centre + half
    double radius;
    int paint; // colour and nearness to the tip: 16 colour + nearness
};

// The distance from p to a part, negative inside; exact.
double part_distance(const struct part *part, const double p[3]);

// A lower bound of the distance between a part and a cube, at most 0.00001 below the distance.
//   half  half of the cube's side
double part_distance_from_cube(const struct part *part, const double centre[3], double half);

// opSmoothUnion of combine.glsl.
double part_union(double a, double b, double blend);

// The distance from p to the smooth union of some parts, joined one after the other in their order.
//   id, count  indices of the parts, and their number; if id is NULL, the first count parts are
//              joined
//   blend      width of the blends, > 0
double parts_distance(const struct part *part, const uint16_t *id, int count, double blend,
                      const double p[3]);

// The part with its numbers rounded to the multiples above, as they are stored.
struct part part_stored(struct part part);

// ---- The grid ----

// The contents of a cell: the parts that matter in it, in their order, which are id[first] to
// id[first + count - 1] of the grid; and a lower bound of the distance from its centre to the
// scene, for a cell without parts.
struct part_cell {
    int first, count;
    double bound;
};

struct part_grid {
    double low[3], size; // corner; side of a cell, a multiple of 1/4096
    int cells[3];
    struct part_cell *cell; // owned: cells[0] in a row along x, then along y, then along z
    uint16_t *id;           // owned: all lists
    int ids;
    double blend;
    int most;   // parts in the longest list
    long tests; // distances computed while building
};

// Build the grid of lists for count parts.
//   blend     width of the blends
//   fineness  cells along the longest side, divided by the cube root of count
// Returns false, without a message, if there is not enough memory. Free with part_grid_free.
bool part_grid_build(struct part_grid *grid, const struct part *part, int count, double blend,
                     double fineness);

void part_grid_free(struct part_grid *grid);

// The cell that contains p; for p outside the grid, the cell of the nearest point inside.
const struct part_cell *part_grid_cell(const struct part_grid *grid, const double p[3]);

#endif
