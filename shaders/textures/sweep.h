// sweep.h - distances again, where a grid has been changed and its values are no distances any
// more.
#ifndef SWEEP_H
#define SWEEP_H

// Replace the values of a grid by the distances to the surface on which they are 0.
//   value  side x side x side numbers, x fastest: negative inside, positive outside, continuous;
//          only their signs and their ratios across the surface matter
//   side   points on each axis, >= 2
//   cell   way between neighbours, > 0
// Points beside the surface get the distance to the plane through the crossings of their edges; all
// others the solution of |gradient| = 1 with differences towards the surface, by eight sweeps, two
// times. The error is about a cell's share near the surface and grows like cell log(1 / cell).
// Where there is no surface, nothing changes.
// Source: H. Zhao, 'A fast sweeping method for eikonal equations', Mathematics of Computation 74
// (2005).
void sweep_distances(double *value, int side, double cell);

#endif
