// sweep.h - makes the values of a grid distances again after some of them have been changed.
#ifndef SWEEP_H
#define SWEEP_H

#include <stdbool.h>

// Replace the values of a grid with the distances to the surface on which they are 0.
//   value  size[0] x size[1] x size[2] numbers, x fastest: negative inside, positive outside,
//          continuous; only their signs and their ratios across the surface matter
//   keep   for each point, true if its value is already a distance and stays; the values beside the
//          surface then stay too, so that the surface does not move. keep is NULL if no value stays
//   size   points on each axis, >= 2
//   cell   distance between neighbours, > 0
// Points next to the surface get the distance to the plane through the crossings of their edges;
// all others get the solution of |gradient| = 1 with differences towards the surface, found in
// eight sweeps. The error is a fraction of a cell near the surface and grows like cell log(1 /
// cell). Where there is no surface and nothing is kept, nothing changes. Source: H. Zhao, 'A fast
// sweeping method for eikonal equations', Mathematics of Computation 74 (2005).
void sweep_distances(double *value, const bool *keep, const int size[3], double cell);

#endif
