// city.h - the city of chapter 09 in double precision.
#ifndef TESTS_CITY_H
#define TESTS_CITY_H

#include "lib/mirror.h"

// The distance to the towers of the blocks around p, `reach` blocks in each direction, found by
// brute force; exact outside the towers. Each tower is two boxes that extend downwards without end.
double city_towers_brute(struct d3 p, int reach);

// The distance to lamps and trees, as the shader computes it, in double precision.
double city_street(struct d3 p);

// The distance to the whole city, as the shader computes it.
//   nearest  receives 0 for a tower, 1 for a lamp, 2 for a tree, 3 for the cap, which is a lower
//            bound on the distance to the towers of other blocks; may be NULL
double city_distance(struct d3 p, int *nearest);

extern const struct mirror_scene city_scene;

#endif
