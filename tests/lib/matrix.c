// Matrices in double precision; see matrix.h.
#include <math.h>

#include "lib/matrix.h"

struct d3 m3_apply(const struct m3 *m, struct d3 v)
{
    return d3_add(d3_times(v.x, m->column[0]),
                  d3_add(d3_times(v.y, m->column[1]), d3_times(v.z, m->column[2])));
}

struct d3 m3_apply_transposed(const struct m3 *m, struct d3 v)
{
    return d3(d3_dot(m->column[0], v), d3_dot(m->column[1], v), d3_dot(m->column[2], v));
}

struct d3 m3_turned(struct d3 axis, double angle, struct d3 v)
{
    struct d3 along = d3_times((1.0 - cos(angle)) * d3_dot(axis, v), axis);
    return d3_add(d3_add(d3_times(cos(angle), v), d3_times(sin(angle), d3_cross(axis, v))), along);
}

struct m3 m3_rotation(double a, double b, double c)
{
    struct m3 m;
    for (int i = 0; i < 3; i++) {
        struct d3 v = d3(i == 0, i == 1, i == 2);
        v = m3_turned(d3(0.0, 1.0, 0.0), b, m3_turned(d3(1.0, 0.0, 0.0), a, v));
        m.column[i] = m3_turned(d3(0.0, 0.0, 1.0), c, v);
    }
    return m;
}

double m3_determinant(const struct m3 *m)
{
    return d3_dot(m->column[0], d3_cross(m->column[1], m->column[2]));
}

// The largest singular value is the square root of the largest eigenvalue of S = transpose(m) m,
// which is found by repeated squaring. S / tr S has trace 1, and repeated squaring removes all but
// the largest eigenvalue.
double m3_largest_stretch(const struct m3 *m)
{
    double logarithm = 0.0, weight = 1.0;
    struct m3 s, next;
    for (int i = 0; i < 3; i++)
        s.column[i] = m3_apply_transposed(m, m->column[i]);
    for (int round = 0; round < 40; round++, weight *= 0.5) {
        double trace = s.column[0].x + s.column[1].y + s.column[2].z;
        logarithm += weight * log(trace);
        for (int i = 0; i < 3; i++)
            s.column[i] = d3_times(1.0 / trace, s.column[i]);
        for (int i = 0; i < 3; i++)
            next.column[i] = m3_apply(&s, s.column[i]);
        s = next;
    }
    return sqrt(exp(logarithm));
}
