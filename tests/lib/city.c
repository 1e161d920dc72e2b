// The city of chapter 09 in double precision; see city.h.
#include <stddef.h>

#include "lib/cell.h"
#include "lib/city.h"

#define PERIOD 6.0
#define GAP    1.35

// The half widths of a tower's shaft and base, and the height of each, in scene units.
struct city_tower {
    double shaft_x, shaft_z, shaft_height, base, base_height;
};

static double fraction(double x)
{
    return x - floor(x);
}

static struct city_tower city_tower_of(int x, int z)
{
    double r = cell_hash(x, z, 9), second = fraction(256.0 * r), third = fraction(65536.0 * r);
    return (struct city_tower){.shaft_x = 0.36 * (2.5 + floor(2.0 * second)),
                               .shaft_z = 0.36 * (2.5 + floor(2.0 * third)),
                               .shaft_height = 0.4 * (4.0 + floor(19.0 * r * r)) + 0.08,
                               .base = 0.36 * 4.5,
                               .base_height = 0.4 * floor(1.0 + 4.0 * third) + 0.08};
}

static double endless_box(struct d3 p, double a, double height, double b)
{
    double x = fabs(p.x) - a, y = p.y - height, z = fabs(p.z) - b;
    double out = sqrt(pow(fmax(x, 0.0), 2.0) + pow(fmax(y, 0.0), 2.0) + pow(fmax(z, 0.0), 2.0));
    return out + fmin(fmax(x, fmax(y, z)), 0.0);
}

static int cell_of(double x)
{
    return (int)floor(x / PERIOD + 0.5);
}

double city_towers_brute(struct d3 p, int reach)
{
    double least = INFINITY;
    for (int i = cell_of(p.x) - reach; i <= cell_of(p.x) + reach; i++)
        for (int k = cell_of(p.z) - reach; k <= cell_of(p.z) + reach; k++) {
            struct city_tower t = city_tower_of(i, k);
            struct d3 local = d3(p.x - PERIOD * i, p.y, p.z - PERIOD * k);
            least = fmin(least, endless_box(local, t.shaft_x, t.shaft_height, t.shaft_z));
            least = fmin(least, endless_box(local, t.base, t.base_height, t.base));
        }
    return least;
}

static struct d3 local_of(struct d3 p)
{
    return d3(p.x - PERIOD * cell_of(p.x), p.y, p.z - PERIOD * cell_of(p.z));
}

static double clamped(double x, double low, double high)
{
    return fmin(fmax(x, low), high);
}

static double lamp(struct d3 q)
{
    double post = d3_length(d3(q.x, fmax(q.y - 1.1, 0.0), q.z)) - 0.018;
    double arm = d3_length(d3(q.x - clamped(q.x, 0.0, 0.26), q.y - 1.1, q.z)) - 0.012;
    return fmin(fmin(post, arm), d3_length(d3_sub(q, d3(0.26, 1.08, 0.0))) - 0.045);
}

static double tree(struct d3 q)
{
    struct d3 c = d3(q.x, q.y - clamped(q.y, 0.5, 1.0), fabs(q.z) - 1.5);
    double crown = 0.98 * (d3_length(c) - 0.3 + 0.2 * clamped(q.y, 0.5, 1.0));
    return fmin(crown, fmax(hypot(c.x, c.z) - 0.03, q.y - 0.6));
}

double city_street(struct d3 p)
{
    struct d3 local = local_of(p), q = d3(fabs(local.x) - 2.1, local.y, local.z);
    return fmin(lamp(q), tree(q));
}

static double slab(double x, double y, double z)
{
    return fmax(x, fmax(y, z));
}

double city_distance(struct d3 p, int *nearest)
{
    struct d3 local = local_of(p), q = d3(fabs(local.x) - 2.1, local.y, local.z);
    struct city_tower t = city_tower_of(cell_of(p.x), cell_of(p.z));
    double x = fabs(local.x), z = fabs(local.z);
    double parts[4] = {fmin(slab(x - t.shaft_x, p.y - t.shaft_height, z - t.shaft_z),
                            slab(x - t.base, p.y - t.base_height, z - t.base)),
                       lamp(q), tree(q), 0.5 * PERIOD - fmax(x, z) + GAP};
    int least = 0;
    for (int i = 1; i < 4; i++)
        if (parts[i] < parts[least])
            least = i;
    if (nearest != NULL)
        *nearest = least;
    return parts[least];
}

const struct mirror_scene city_scene = {NULL, 0, city_distance};
