#include "lib/pyramid.h"

#include <math.h>

#define PYRAMID_SIZE 1.1

enum { LEVELS = 7 };

static const struct d3 slab = {0.0, -0.1, 0.0}, slab_half = {4.2, 0.1, 3.2};

struct tetrahedron {
    struct d3 corner[4];
};

// The pyramid rests on the ground, with its apex above x = -0.7, z = -0.5 and one lower corner
// towards the viewer. Each edge has length sqrt(8) * PYRAMID_SIZE.
static struct tetrahedron whole_pyramid(void)
{
    struct tetrahedron t;
    double radius = sqrt(8.0 / 3.0) * PYRAMID_SIZE;
    t.corner[0] = d3(-0.7, 4.0 / sqrt(3.0) * PYRAMID_SIZE, -0.5);
    for (int k = 1; k < 4; k++) {
        double angle = (90.0 + 120.0 * k) * MIRROR_PI / 180.0;
        t.corner[k] = d3(-0.7 + radius * cos(angle), 0.0, -0.5 + radius * sin(angle));
    }
    return t;
}

// The outward unit normal of the face opposite corner k.
static struct d3 face_normal(const struct tetrahedron *t, int k)
{
    struct d3 a = t->corner[(k + 1) % 4], b = t->corner[(k + 2) % 4], c = t->corner[(k + 3) % 4];
    struct d3 normal = d3_unit(d3_cross(d3_sub(b, a), d3_sub(c, a)));
    return d3_dot(normal, d3_sub(t->corner[k], a)) > 0.0 ? d3_times(-1.0, normal) : normal;
}

static double face_distance(const struct tetrahedron *t, int k, struct d3 p)
{
    return d3_dot(d3_sub(p, t->corner[(k + 1) % 4]), face_normal(t, k));
}

static double largest_distance(const struct tetrahedron *t, struct d3 p)
{
    double largest = -HUGE_VAL;
    for (int k = 0; k < 4; k++)
        largest = fmax(largest, face_distance(t, k, p));
    return largest;
}

// One level: reflect p to the apex's side, and halve the edges towards the apex.
static void fold(struct tetrahedron *t, struct d3 *p)
{
    struct d3 apex = t->corner[0];
    for (int k = 1; k < 4; k++) {
        struct d3 middle = d3_times(0.5, d3_add(apex, t->corner[k]));
        struct d3 normal = d3_unit(d3_sub(apex, t->corner[k]));
        double side = d3_dot(d3_sub(*p, middle), normal);
        if (side < 0.0)
            *p = d3_sub(*p, d3_times(2.0 * side, normal));
    }
    for (int k = 1; k < 4; k++)
        t->corner[k] = d3_times(0.5, d3_add(apex, t->corner[k]));
}

static double scene_function(struct d3 p, int *nearest)
{
    struct tetrahedron t = whole_pyramid();
    double ground = mirror_box(d3_sub(p, slab), slab_half);
    for (int i = 0; i < LEVELS; i++)
        fold(&t, &p);
    double stone = largest_distance(&t, p);
    *nearest = stone < ground;
    return fmin(stone, ground);
}

const struct mirror_scene pyramid_scene = {.function = scene_function};
