#include "lib/boundary.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "lib/mirror.h"

#define SAMPLES 16

struct d2 boundary_at(const struct piece *piece, double u)
{
    u = piece->low + u * (piece->high - piece->low);
    if (!piece->arc)
        return (struct d2){piece->a.x + u * (piece->b.x - piece->a.x),
                           piece->a.y + u * (piece->b.y - piece->a.y)};
    double angle = piece->from + u * (piece->to - piece->from);
    return (struct d2){piece->a.x + piece->b.x * cos(angle), piece->a.y + piece->b.y * sin(angle)};
}

void boundary_add_segment(struct boundary *of, struct d2 a, struct d2 b)
{
    assert_true(of->count < BOUNDARY_MOST);
    of->piece[of->count++] = (struct piece){.a = a, .b = b, .high = 1.0};
}

// An arc consists of two halves, because the search in a piece does not continue from its end to
// its beginning, as a closed ellipse would require.
void boundary_add_ellipse(struct boundary *of, struct d2 centre, struct d2 axes, double from,
                          double to)
{
    assert_true(of->count + 2 <= BOUNDARY_MOST);
    double middle = 0.5 * (from + to);
    of->piece[of->count++] = (struct piece){true, centre, axes, from, middle, 0.0, 1.0};
    of->piece[of->count++] = (struct piece){true, centre, axes, middle, to, 0.0, 1.0};
}

void boundary_add_arc(struct boundary *of, double x, double y, double radius, double from,
                      double to)
{
    boundary_add_ellipse(of, (struct d2){x, y}, (struct d2){radius, radius}, from, to);
}

void boundary_add_polygon(struct boundary *of, const double (*corner)[2], int count)
{
    for (int i = 0; i < count; i++) {
        const double *a = corner[i], *b = corner[(i + 1) % count];
        boundary_add_segment(of, (struct d2){a[0], a[1]}, (struct d2){b[0], b[1]});
    }
}

static double apart(struct d2 p, const struct piece *piece, double u)
{
    struct d2 at = boundary_at(piece, u);
    return hypot(p.x - at.x, p.y - at.y);
}

// The distance to a piece, from a golden-section search that starts at the nearest sample.
static double piece_distance(struct d2 p, const struct piece *piece)
{
    const double golden = 0.6180339887498949;
    int best = 0;
    double nearest = INFINITY;
    for (int i = 0; i <= SAMPLES; i++) {
        double d = apart(p, piece, (double)i / SAMPLES);
        best = d < nearest ? i : best;
        nearest = fmin(nearest, d);
    }
    double low = fmax(best - 1.0, 0.0) / SAMPLES, high = fmin(best + 1.0, SAMPLES) / SAMPLES;
    for (int i = 0; i < 36; i++) {
        double left = high - golden * (high - low), right = low + golden * (high - low);
        if (apart(p, piece, left) < apart(p, piece, right))
            high = right;
        else
            low = left;
    }
    return fmin(nearest, apart(p, piece, 0.5 * (low + high)));
}

double boundary_distance(struct d2 p, const struct boundary *of)
{
    double nearest = INFINITY;
    for (int i = 0; i < of->count; i++)
        nearest = fmin(nearest, piece_distance(p, &of->piece[i]));
    return nearest;
}

double boundary_winding(struct d2 p, const double (*corner)[2], int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++) {
        const double *a = corner[i], *b = corner[(i + 1) % count];
        double x = a[0] - p.x, y = a[1] - p.y, u = b[0] - p.x, v = b[1] - p.y;
        sum += atan2(x * v - y * u, x * u + y * v);
    }
    return sum / (2.0 * MIRROR_PI);
}
