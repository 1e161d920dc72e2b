// sculpt.h - clay that is added to a grid of distances or taken away from it.
//
// A grid has ELEPHANT_SIDE points on each axis, from -1 to 1, and four bytes for each point, x
// fastest: red is the high byte of a distance, green the low byte (elephant.h). shaders/stored.glsl
// reads such grids. docs/23_stored_distances.md proves the claims made here.
#ifndef SCULPT_H
#define SCULPT_H

#include <stdbool.h>

enum { SCULPT_BYTES = 4 };

#define SCULPT_BLEND 0.05 // width of the smooth union of the clay and a roll, scene units
#define SCULPT_REACH 0.93 // no clay is added farther than this from the centre on any axis

// The stored distance at any point, as storedDistance of shaders/stored.glsl computes it.
double sculpt_value(const unsigned char *grid, const double p[3]);

// March along a ray with the steps of storedStep.
//   direction  of length 1
//   hit        receives the first point of the march where the stored distance is below 0.0001
// Returns false if there is no such point within a distance of 20.
bool sculpt_march(const unsigned char *grid, const double origin[3], const double direction[3],
                  double hit[3]);

// Add a roll of clay, a capsule from one point to another, or take it away, and make the values
// distances again.
//   grid      the grid that is changed
//   before    the same grid as it was before the first piece of a stroke. The pieces of a stroke
//             are first united with each other and then blended with this grid, so that their
//             joints do not swell
//   radius    of the roll; negative to take clay away
//   slices    receives the first slice in z that may have changed, and the slice after the last;
//             (0, 0) if no slice may have changed
//   formula   min(F, U(F before, r)) where clay is added, max(F, -U(-F before, r)) where it is
//             taken away; F is the value at a point, r the distance to the roll, and U the
//             quadratic smooth union. A point with r >= |F| + SCULPT_BLEND keeps its value, because
//             no surface nearer than |F| has changed. The blended values beside the new surface
//             stay; all others are swept
void sculpt_piece(unsigned char *grid, const unsigned char *before, const double from[3],
                  const double to[3], double radius, int slices[2]);

#endif
