// sweep.h - restores distances in a grid whose values have been changed and are no longer
// distances.
#ifndef SWEEP_H
#define SWEEP_H

// Replace the values of a grid with the distances to the surface on which they are 0.
//   value  side x side x side numbers, x fastest: negative inside, positive outside, continuous;
//          only their signs and their ratios across the surface matter
//   side   points on each axis, >= 2
//   cell   distance between neighbours, > 0
// Points next to the surface get the distance to the plane through the crossings of their edges.
// All others get the solution of |gradient| = 1 with differences towards the surface, in eight
// sweeps, made twice. The error is a fraction of a cell near the surface, and grows like
// cell log(1 / cell). If there is no surface, nothing changes.
// Source: H. Zhao, 'A fast sweeping method for eikonal equations', Mathematics of Computation 74
// (2005).
void sweep_distances(double *value, int side, double cell);

#endif
