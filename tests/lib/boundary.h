// boundary.h - a boundary in the plane, made of pieces, and the distance to it, found by a search
// in double precision, for tests of figures.
#ifndef TESTS_BOUNDARY_H
#define TESTS_BOUNDARY_H

#include <stdbool.h>

#define BOUNDARY_MOST 48 // the largest number of pieces

struct d2 {
    double x, y;
};

// A piece of a boundary: a segment from a to b, or an arc of the ellipse with the centre a and the
// semi-axes b, between the angles `from` and `to`. Only the part between the fractions low and high
// of the segment, or of the range of angles, belongs to the boundary.
struct piece {
    bool arc;
    struct d2 a, b;
    double from, to, low, high;
};

struct boundary {
    struct piece piece[BOUNDARY_MOST];
    int count;
};

// The point at the fraction u of the part of a piece that belongs to the boundary.
struct d2 boundary_at(const struct piece *piece, double u);

// Each of these functions adds pieces to a boundary: a segment; an arc of an ellipse or of a
// circle, between two angles in radians; or the sides of a closed polygon.
void boundary_add_segment(struct boundary *of, struct d2 a, struct d2 b);
void boundary_add_ellipse(struct boundary *of, struct d2 centre, struct d2 axes, double from,
                          double to);
void boundary_add_arc(struct boundary *of, double x, double y, double radius, double from,
                      double to);
void boundary_add_polygon(struct boundary *of, const double (*corner)[2], int count);

// The distance from p to the nearest point of a boundary. For each piece, a golden-section search
// starts at the nearest of 17 samples.
double boundary_distance(struct d2 p, const struct boundary *of);

// The winding number of a polygon around p: the sum of the signed angles that its sides subtend
// at p, in turns.
double boundary_winding(struct d2 p, const double (*corner)[2], int count);

#endif
