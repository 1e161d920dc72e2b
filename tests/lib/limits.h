// limits.h - a march in 32-bit floats far from the origin, compared with double precision, for
// proof 5 of docs/16_fewer_steps.md.
#ifndef TESTS_LIMITS_H
#define TESTS_LIMITS_H

#include "lib/gpu.h"
#include "lib/mirror.h"

enum { LIMITS_CASES = 4096, LIMITS_SHEETS = 2 };

// The results for rays that are aimed at a sheet without thickness: a hollow ball or a hollow box.
struct limits_sums {
    double error;     // the largest ratio of a distance's error to the proved bound
    double absolute;  // the largest error of a distance, scene units
    double threshold; // the proved threshold at t = 4, scene units
    int rays;         // rays that clearly cross the sheet
    int passed;       // of these rays, those that missed the sheet or ended behind it by more than
                      // the proved threshold
};

// March LIMITS_CASES rays.
//   sheet      0 for the ball, 1 for the box
//   away       x coordinate of the sheet's middle, scene units
//   threshold  as a multiple of the proved threshold
struct limits_sums limits_of(int sheet, double away, double threshold);

// Print a table. Returns an exit status.
int limits_print(void);

#endif
