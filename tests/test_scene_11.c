// test_scene_11.c - the still life of chapter 11 in double precision: pixels of its picture, and
// what it is made of.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_gloss.h"
#include "support_pixels.h"

#define CHAPTER "11_materials"

static const double blend = 0.45, lemon_blend = 0.22, wall = -2.2, far_end = 40.0,
                    threshold = 0.001;
static const double holes = 0.24, tile = 0.42, silver_radius = 0.34;
static const struct d3 to_light = {-0.7433, 0.5213, 0.4194};
static const struct d3 window_light = {2.25, 1.86, 1.34}, room_light = {0.060, 0.062, 0.052};

static double wax_share; // of the picture's time

// ---- Distances, told once more ----

static double smooth_union(double a, double b, double k)
{
    double h = fmax(1.0 - fabs(a - b) / k, 0.0);
    return fmin(a, b) - k * h * h * h / 6.0;
}

static double share_of(double a, double b, double k)
{
    double h = fmax(1.0 - fabs(a - b) / k, 0.0), lesser = 0.5 * h * h;
    return a < b ? lesser : 1.0 - lesser;
}

static double largest(double a, double b, double c)
{
    return fmax(a, fmax(b, c));
}

static double jug(struct d3 p)
{
    double x = p.x + 1.3, y = p.y - 0.62, z = p.z + 0.5, side = hypot(x, z);
    double neck = fmax(0.97 * (side - fmax(0.25, 0.25 * y + 0.06)), fabs(y - 0.6) - 0.5);
    double body = smooth_union(hypot(side, y) - 0.64, neck, 0.35);
    double hollow = fmax(side - 0.2, 0.5 - y);
    double handle = fmax(fabs(hypot(x + 0.42, y - 0.5) - 0.36) - 0.04, fabs(z) - 0.075);
    return fmin(fmax(body, -hollow), handle);
}

static double bowl(struct d3 p)
{
    struct d3 q = d3_sub(p, d3(0.45, 0.82, -0.35));
    double away = d3_length(q);
    return fmin(fmax(fabs(away - 0.78) - 0.04, q.y), fmax(away - 0.88, fabs(q.y + 0.80) - 0.03));
}

static void lemon(struct d3 p, double ball[2])
{
    struct d3 q = d3_sub(p, d3(0.2, 0.93, -0.2));
    struct d3 r = d3(0.92 * q.x + 0.39 * q.y, 0.92 * q.y - 0.39 * q.x, q.z);
    ball[0] = d3_length(q) - 0.33;
    ball[1] = d3_length(d3(fabs(r.x) - 0.37, r.y, r.z)) - 0.07;
}

static void pear(struct d3 p, double ball[2])
{
    ball[0] = d3_length(d3_sub(p, d3(1.3, 0.42, 0.55))) - 0.43;
    ball[1] = d3_length(d3_sub(p, d3(1.35, 0.96, 0.55))) - 0.22;
}

static double stalk(struct d3 p)
{
    return largest(fabs(p.x - 1.37) - 0.022, fabs(p.z - 0.55) - 0.022, fabs(p.y - 1.27) - 0.14);
}

static double silver(struct d3 p)
{
    return d3_length(d3_sub(p, d3(-0.45, silver_radius, 0.75))) - silver_radius;
}

static double ivory(struct d3 p)
{
    double x = p.x - 2.3, y = p.y - 0.36, z = p.z + 0.05;
    struct d3 q = d3(0.8 * x + 0.6 * z, y, 0.8 * z - 0.6 * x);
    double box = largest(fabs(q.x), fabs(q.y), fabs(q.z)) - 0.36;
    struct d3 cell = d3(remainder(q.x, holes), remainder(q.y, holes), remainder(q.z, holes));
    return fmax(box, 0.148 - d3_length(cell));
}

static double wax(struct d3 p)
{
    double x = p.x - 0.45, y = p.y - 0.18, z = p.z - 1.1;
    struct d3 q = d3(0.8 * x - 0.6 * z, y, 0.6 * x + 0.8 * z);
    double box = largest(fabs(q.x), fabs(q.y), fabs(q.z)) - 0.18;
    return (1.0 - wax_share) * box + wax_share * (d3_length(q) - 0.2);
}

enum { TABLE, WALL, JUG, BOWL, LEMON, PEAR, STALK, SILVER, IVORY, WAX, PARTS };

static double scene_distance(struct d3 p, int *nearest)
{
    double a[2], b[2];
    lemon(p, a);
    pear(p, b);
    double part[PARTS] = {[TABLE] = p.y,
                          [WALL] = p.z - wall,
                          [JUG] = jug(p),
                          [BOWL] = bowl(p),
                          [LEMON] = smooth_union(a[0], a[1], lemon_blend),
                          [PEAR] = smooth_union(b[0], b[1], blend),
                          [STALK] = stalk(p),
                          [SILVER] = silver(p),
                          [IVORY] = ivory(p),
                          [WAX] = wax(p)};
    return mirror_nearest(part, PARTS, nearest);
}

// ---- Marches ----

static bool things_interval(struct mirror_ray ray, double t[2])
{
    double a[2], b[2];
    bool in_a = brute_box_interval(ray, d3(-0.82, -0.02, -1.20), d3(2.82, 1.43, 1.38), a);
    bool in_b = brute_box_interval(ray, d3(-2.14, -0.02, -1.16), d3(-0.64, 1.74, 0.16), b);
    t[0] = fmin(in_a ? a[0] : HUGE_VAL, in_b ? b[0] : HUGE_VAL);
    t[1] = fmax(in_a ? a[1] : -1.0, in_b ? b[1] : -1.0);
    return in_a || in_b;
}

static bool march_cone(struct mirror_ray ray, double start, double spread, double *t)
{
    double things[2];
    double table = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : far_end;
    double upright = ray.direction.z < 0.0 ? (wall - ray.origin.z) / ray.direction.z : far_end;
    double end = fmin(table, upright);
    *t = (things_interval(ray, things) ? fmin(things[0], end) : end) - 0.01;
    for (int i = 0; i < 96 && *t < end + 0.3; i++) {
        double distance = scene_distance(mirror_at(ray, *t), NULL);
        if (distance < start + spread * *t)
            return true;
        *t += distance;
    }
    return false;
}

static double light_share(struct mirror_ray ray, double radius)
{
    double t[2], smallest = 1.0;
    if (!things_interval(ray, t))
        return 1.0;
    for (int i = 0; i < 96 && t[0] < t[1] && smallest > 0.2; i++) {
        double distance = scene_distance(mirror_at(ray, t[0]), NULL);
        smallest = fmin(smallest, distance / (radius + 0.04 * t[0]));
        t[0] += distance;
    }
    return fmax((smallest - 0.2) / 0.8, 0.0);
}

static struct d3 normal_at(struct d3 p, double h)
{
    double g[3];
    if (p.z < wall + h)
        return d3(0.0, 0.0, 1.0);
    if (p.y < h)
        return d3(0.0, 1.0, 0.0);
    for (int k = 0; k < 3; k++) {
        struct d3 step = d3(k == 0 ? h : 0.0, k == 1 ? h : 0.0, k == 2 ? h : 0.0);
        g[k] = scene_distance(d3_add(p, step), NULL) - scene_distance(d3_sub(p, step), NULL);
    }
    return d3_unit(d3(g[0], g[1], g[2]));
}

// ---- Materials ----

struct material {
    struct d3 colour, straight;
    double roughness;
};

static struct d3 mix(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

static struct material plain(double r, double g, double b, double straight, double roughness)
{
    return (struct material){d3(r, g, b), d3(straight, straight, straight), roughness};
}

static struct material blended(struct material a, struct material b, double share)
{
    return (struct material){mix(a.colour, b.colour, share), mix(a.straight, b.straight, share),
                             (1.0 - share) * a.roughness + share * b.roughness};
}

// The mean of the squares over the rectangle that the pixel's corners span, by counting along each
// axis.
static double linen_share(const struct mirror_eye *eye, double half)
{
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, even[2] = {0.0, 0.0};
    for (int i = 0; i < 4; i++) {
        struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH,
                                                  eye->x + (i % 2 == 0 ? -half : half),
                                                  eye->y + (i < 2 ? -half : half));
        struct d3 p = mirror_at(ray, -ray.origin.y / ray.direction.y);
        double place[2] = {(p.x + p.z) * sqrt(0.5) / tile, (p.x - p.z) * sqrt(0.5) / tile};
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], place[k]);
            high[k] = fmax(high[k], place[k]);
        }
    }
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 500; i++)
            even[k] += fmod(floor(low[k] + (high[k] - low[k]) * (i + 0.5) / 500.0), 2.0) == 0.0
                           ? 0.002
                           : 0.0;
    return even[0] * even[1] + (1.0 - even[0]) * (1.0 - even[1]);
}

static struct material material_at(struct d3 p, int part, const struct mirror_eye *eye)
{
    double ball[2];
    switch (part) {
    case TABLE:
        return blended(plain(0.12, 0.018, 0.015, 0.03, 0.8), plain(0.46, 0.39, 0.29, 0.03, 0.8),
                       linen_share(eye, 1.0 / 360.0));
    case WALL:
        return plain(0.16, 0.175, 0.14, 0.03, 0.9);
    case JUG:
        return plain(0.30, 0.095, 0.04, 0.04, 0.75);
    case BOWL:
        return blended(plain(0.015, 0.05, 0.16, 0.06, 0.12), plain(0.50, 0.45, 0.36, 0.06, 0.15),
                       mirror_smoothstep(0.77, 0.80, p.y));
    case LEMON:
        lemon(p, ball);
        return blended(plain(0.66, 0.37, 0.02, 0.04, 0.38), plain(0.25, 0.28, 0.03, 0.04, 0.5),
                       share_of(ball[0], ball[1], lemon_blend));
    case PEAR:
        pear(p, ball);
        return blended(plain(0.46, 0.40, 0.06, 0.04, 0.34), plain(0.38, 0.05, 0.02, 0.04, 0.30),
                       share_of(ball[0], ball[1], blend));
    case IVORY:
        return plain(0.62, 0.51, 0.34, 0.05, 0.40);
    case WAX:
        return blended(plain(0.02, 0.08, 0.05, 0.04, 0.22), plain(0.55, 0.25, 0.03, 0.04, 0.30),
                       wax_share);
    default:
        return plain(0.07, 0.04, 0.02, 0.04, 0.7);
    }
}

// ---- Light ----

static double pane(double x, double y, double half_x, double half_y, double soft)
{
    return (1.0 - mirror_smoothstep(half_x - soft, half_x + soft, fabs(x))) *
           (1.0 - mirror_smoothstep(half_y - soft, half_y + soft, fabs(y)));
}

static struct d3 room_seen(struct d3 d, double roughness)
{
    double below = fmin(d.x, -0.1), y = d.y / below + 0.55, z = d.z / below + 0.45;
    double bars = 1.0 - mirror_smoothstep(0.018, 0.042, fmin(fabs(y), fabs(z)));
    double window =
        pane(y, z, 0.36, 0.3, 0.02 + roughness) * (1.0 - bars * fmax(1.0 - 4.0 * roughness, 0.0));
    return d3_add(d3_times(0.6 + 0.4 * d.y, room_light),
                  d3_times(8.0 * window / (1.0 + 9.0 * roughness), window_light));
}

static double shaft(struct d3 p)
{
    double s = (p.x + 6.0) / to_light.x;
    return 0.06 +
           0.94 * pane(p.y - to_light.y * s - 4.8, p.z - to_light.z * s - 2.5, 2.0, 2.4, 0.5);
}

static struct d3 mirrored_share(struct material m, double facing)
{
    return mix(m.straight, d3(1.0, 1.0, 1.0), pow(1.0 - mirror_clamp(facing), 5.0));
}

// A direction in a frame whose third axis is the normal, for the highlights of support_gloss.
static struct d3 seen_from(struct d3 v, struct d3 normal, struct d3 across)
{
    struct d3 x = d3_unit(d3_sub(across, d3_times(d3_dot(across, normal), normal)));
    return d3(d3_dot(v, x), d3_dot(v, d3_cross(normal, x)), d3_dot(v, normal));
}

static struct d3 surface_light(struct d3 p, struct d3 normal, struct d3 to_eye, struct material m,
                               double radius, struct mirror_sample *sample)
{
    struct mirror_ray ray = {d3_add(p, d3_times(4.0 * radius, normal)), to_light};
    double facing = mirror_lambert(normal, to_light);
    double seen = facing > 0.0 ? light_share(ray, 2.0 * radius) : 1.0;
    struct d3 half = d3_unit(d3_add(to_light, to_eye));
    struct d3 mirrored = mirrored_share(m, d3_dot(to_eye, half));
    struct d3 across = d3(0.3, 0.7, 0.2);
    double gloss = gloss_ggx(seen_from(to_light, normal, across), seen_from(to_eye, normal, across),
                             m.roughness);
    struct d3 received = d3_times(seen * shaft(p) * facing, window_light);
    struct d3 matt = d3_product(m.colour, d3_sub(d3(1.0, 1.0, 1.0), mirrored));
    struct d3 sent = d3_add(matt, d3_times(MIRROR_PI * gloss, mirrored));
    struct d3 room = d3_add(d3_times(0.8 + 0.2 * normal.y - 0.35 * normal.x, room_light),
                            d3_times(fmax(-normal.y, 0.0), d3(0.050, 0.020, 0.010)));
    sample->faces = facing > 0.0;
    sample->shadowed = sample->faces && seen < 0.5;
    return d3_add(d3_product(sent, received), d3_product(m.colour, room));
}

static struct mirror_sample sample_at(const struct mirror_eye *eye)
{
    static const char *const names[PARTS] = {"table", "wall",  "jug",    "bowl",  "lemon",
                                             "pear",  "stalk", "silver", "ivory", "wax"};
    struct mirror_sample sample = {.what = "nothing"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    double spread = d3_dot(ray.direction, d3_of(camera_basis_of(&eye->camera).forward)) /
                    (360.0 * MIRROR_FOCAL_LENGTH);
    double t;
    int part;
    wax_share = 0.5 - 0.5 * cos(0.5 * eye->time + 1.2);
    if (!march_cone(ray, threshold, spread, &t))
        return sample;
    struct d3 p = mirror_at(ray, t);
    double radius = threshold + spread * t;
    scene_distance(p, &part);
    sample.what = names[part];
    if (part == SILVER) // mirrors the rest; no pixel of it is listed
        return sample;
    struct d3 normal = normal_at(p, radius), to_eye = d3_times(-1.0, ray.direction);
    struct material m = material_at(p, part, eye);
    struct d3 light = surface_light(p, normal, to_eye, m, radius, &sample);
    double facing = d3_dot(to_eye, normal), smooth = (1.0 - m.roughness) * (1.0 - m.roughness);
    struct d3 away = d3_sub(d3_times(2.0 * facing, normal), to_eye);
    light = d3_add(light, d3_times(smooth, d3_product(mirrored_share(m, facing),
                                                      room_seen(away, m.roughness))));
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 332, 155, "bowl+"},  {CHAPTER, 281, 168, "bowl+"},  {CHAPTER, 349, 155, "bowl+"},
    {CHAPTER, 315, 142, "bowl+"},  {CHAPTER, 366, 155, "bowl-"},  {CHAPTER, 383, 168, "bowl-"},
    {CHAPTER, 366, 142, "bowl-"},  {CHAPTER, 349, 129, "bowl-"},  {CHAPTER, 468, 142, "ivory#"},
    {CHAPTER, 485, 116, "ivory#"}, {CHAPTER, 502, 129, "ivory#"}, {CHAPTER, 485, 129, "ivory#"},
    {CHAPTER, 519, 168, "ivory+"}, {CHAPTER, 162, 168, "jug+"},   {CHAPTER, 145, 233, "jug+"},
    {CHAPTER, 196, 194, "jug+"},   {CHAPTER, 179, 207, "jug+"},   {CHAPTER, 213, 220, "jug-"},
    {CHAPTER, 230, 194, "jug-"},   {CHAPTER, 145, 194, "jug-"},   {CHAPTER, 213, 155, "jug-"},
    {CHAPTER, 315, 181, "lemon+"}, {CHAPTER, 298, 207, "lemon+"}, {CHAPTER, 315, 207, "lemon+"},
    {CHAPTER, 315, 194, "lemon+"}, {CHAPTER, 332, 181, "lemon-"}, {CHAPTER, 400, 181, "pear+"},
    {CHAPTER, 417, 194, "pear+"},  {CHAPTER, 434, 103, "pear+"},  {CHAPTER, 417, 116, "pear+"},
    {CHAPTER, 451, 116, "pear-"},  {CHAPTER, 519, 103, "table#"}, {CHAPTER, 553, 116, "table#"},
    {CHAPTER, 366, 77, "table#"},  {CHAPTER, 451, 90, "table#"},  {CHAPTER, 553, 103, "table+"},
    {CHAPTER, 485, 77, "table+"},  {CHAPTER, 196, 90, "table+"},  {CHAPTER, 553, 77, "table+"},
    {CHAPTER, 60, 324, "wall+"},   {CHAPTER, 77, 337, "wall+"},   {CHAPTER, 9, 298, "wall+"},
    {CHAPTER, 111, 272, "wall+"},  {CHAPTER, 315, 77, "wax+"},    {CHAPTER, 332, 77, "wax+"},
    {CHAPTER, 332, 64, "wax+"},    {CHAPTER, 332, 90, "wax+"},    {CHAPTER, 349, 64, "wax-"},
    {CHAPTER, 349, 77, "wax-"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    pixels_check_chapter(CHAPTER, sample_at, pixels, sizeof pixels / sizeof *pixels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
    };
    return cmocka_run_group_tests_name("scene 11", tests, gpu_setup, gpu_teardown);
}
