// matrix.h - 3 x 3 matrices in double precision, with formulas other than the library's.
#ifndef TESTS_MATRIX_H
#define TESTS_MATRIX_H

#include "lib/mirror.h"

struct m3 {
    struct d3 column[3];
};

// The products of m and of its transpose with v.
struct d3 m3_apply(const struct m3 *m, struct d3 v);
struct d3 m3_apply_transposed(const struct m3 *m, struct d3 v);

double m3_determinant(const struct m3 *m);

// The largest factor by which m stretches a vector: the largest singular value of m.
double m3_largest_stretch(const struct m3 *m);

// v turned about an axis of length 1 by an angle in radians, using Rodrigues' formula.
struct d3 m3_turned(struct d3 axis, double angle, struct d3 v);

// The rotation about x by a, then about y by b, then about z by c, in radians.
struct m3 m3_rotation(double a, double b, double c);

#endif
