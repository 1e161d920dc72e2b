// test_scene_13.c - the terrace of chapter 13 in double precision: pixels of its picture, umbra,
// penumbra and light.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_cell.h"
#include "support_pixels.h"

#define CHAPTER "13_soft_shadows"

enum { HEIGHT = 360, MAX_STEPS = 96 };

static const double threshold = 0.0005, sun_spread = 0.04;
static const double pixel_spread = 1.0 / (HEIGHT * MIRROR_FOCAL_LENGTH);
static const struct d3 low = {-10.1, -0.01, -5.3}, high = {6.9, 2.78, 2.9};

// ---- The scene ----

static double box(struct d3 p, double x, double y, double z, double a, double b, double c)
{
    return brute_box(d3_sub(p, d3(x, y, z)), d3(a, b, c));
}

static double trellis(struct d3 p)
{
    double nearest = box(p, -2.9, 2.67, -0.9, 0.09, 0.07, 3.7);
    for (int i = -7; i <= 4; i++)
        nearest = fmin(nearest, box(p, -2.9, 1.3, 0.6 * i, 0.04, 1.3, 0.04));
    return nearest;
}

static double smooth_union(double a, double b, double k)
{
    double h = fmax(k - fabs(a - b), 0.0);
    return fmin(a, b) - h * h * h / (6.0 * k * k);
}

static double figure(struct d3 p)
{
    struct d3 q = d3_sub(p, d3(1.45, 0.0, 0.1));
    double height = fmin(fmax(q.y, 0.2), 1.6), taper = 0.16 - 0.12 * (height - 0.2) / 1.4;
    double body = 0.995 * (d3_length(d3(q.x, q.y - height, q.z)) - taper);
    double shoulders = d3_length(d3(q.x, q.y - 1.4, q.z)) - 0.115;
    double head = d3_length(d3(q.x, q.y - 1.76, q.z)) - 0.1;
    double plinth = box(q, 0.0, 0.1, 0.0, 0.24, 0.1, 0.24);
    return fmin(plinth, fmin(smooth_union(body, shoulders, 0.25), head));
}

static double ball(struct d3 p)
{
    return d3_length(d3_sub(p, d3(0.1, 0.42, -1.7))) - 0.42;
}

static double stairs(struct d3 p)
{
    double nearest = HUGE_VAL;
    for (int i = 0; i < 3; i++)
        nearest = fmin(nearest, box(p, 4.5 + 0.45 * i, 0.0, -3.0 - 0.2 * i, 1.9, 0.2 * (i + 1),
                                    1.9 - 0.2 * i));
    return nearest;
}

static const char *const names[] = {"parapet", "ball", "trellis", "figure", "stairs"};

static double distance_of(struct d3 p, int *nearest)
{
    const double all[] = {box(p, 0.0, 0.2, -5.1, 10.0, 0.2, 0.15), ball(p), trellis(p), figure(p),
                          stairs(p)};
    int best = 0;
    for (int i = 1; i < 5; i++)
        best = all[i] < all[best] ? i : best;
    if (nearest != NULL)
        *nearest = best;
    return all[best];
}

static struct d3 normal_at(struct d3 p, double h)
{
    double g[3];
    for (int k = 0; k < 3; k++) {
        struct d3 step = d3(k == 0 ? h : 0.0, k == 1 ? h : 0.0, k == 2 ? h : 0.0);
        g[k] = distance_of(d3_add(p, step), NULL) - distance_of(d3_sub(p, step), NULL);
    }
    return d3_unit(d3(g[0], g[1], g[2]));
}

// ---- The sun ----

static struct d3 sun_direction(void)
{
    double azimuth = 214.0 * MIRROR_PI / 180.0, up = 29.0 * MIRROR_PI / 180.0;
    return d3(cos(up) * cos(azimuth), sin(up), cos(up) * sin(azimuth));
}

// By pairs of steps.
static double sun_seen(struct mirror_ray ray)
{
    double interval[2], t = 0.0, before = 1e6, least = 1e6;
    struct d3 room = d3(0.4, 0.4, 0.4);
    if (!brute_box_interval(ray, d3_sub(low, room), d3_add(high, room), interval))
        return 1.0;
    for (int step = 0; step < MAX_STEPS && t < interval[1]; step++) {
        double h = distance_of(mirror_at(ray, t), NULL);
        if (h < threshold)
            return 0.0;
        double back = h * h / (2.0 * before);
        if (t > back)
            least = fmin(least, sqrt(fmax(h * h - back * back, 0.0)) / (t - back));
        before = h;
        t += h;
    }
    return fmin(least / sun_spread, 1.0);
}

// ---- Colours ----

static struct d3 mix(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

static double coverage(double inside, double width)
{
    return mirror_clamp(inside / (width + 0.001) + 0.5);
}

// A joint of 0.014 in each stone.
static double joint(double x, double width)
{
    double share = coverage(0.007 - fabs(x - floor(x) - 0.5), width);
    return share + mirror_smoothstep(0.4, 1.0, width) * (0.014 - share);
}

static struct d3 floor_colour(struct d3 p, struct d3 direction, double radius)
{
    double x = p.x / 0.9, z = p.z / 0.9, width = 2.0 * radius / 0.9;
    double a = joint(x, width * (1.0 + fabs(direction.x / direction.y)));
    double b = joint(z, width * (1.0 + fabs(direction.z / direction.y)));
    double tone = cell_hash((int)floor(x + 0.5), (int)floor(z + 0.5), 3);
    double share = (0.94 + 0.1 * tone) * (1.0 - 0.35 * fmax(a, b));
    return d3_times(share, d3(0.80, 0.76, 0.70));
}

static struct d3 sky_light(struct d3 direction, struct d3 to_sun)
{
    double facing = 0.5 + 0.5 * d3_dot(direction, to_sun), y = direction.y;
    struct d3 peach = mix(d3(0.95, 0.72, 0.60), d3(1.0, 0.78, 0.55), facing * facing);
    struct d3 sky = mix(peach, d3(0.34, 0.54, 0.78), mirror_smoothstep(0.0, 0.42, y));
    struct d3 sea =
        mix(d3(0.45, 0.60, 0.68), d3(0.72, 0.70, 0.68), mirror_smoothstep(-0.12, 0.0, y));
    return mix(sea, sky, mirror_smoothstep(-0.002, 0.002, y));
}

static struct d3 place_light(struct mirror_ray ray, double t, bool found,
                             struct mirror_sample *sample)
{
    struct d3 p = mirror_at(ray, t), to_sun = sun_direction();
    double radius = threshold + pixel_spread * t, seen = 1.0;
    int part = 0;
    struct d3 normal = found ? normal_at(p, radius) : d3(0.0, 1.0, 0.0);
    struct d3 colour = found ? d3(0.80, 0.76, 0.70) : floor_colour(p, ray.direction, radius);
    double facing = mirror_lambert(normal, to_sun);
    if (facing > 0.0)
        seen = sun_seen((struct mirror_ray){d3_add(p, d3_times(2.0 * radius, normal)), to_sun});
    distance_of(p, &part);
    sample->what = !found ? (seen > 0.1 && seen < 0.9 ? "penumbra" : "floor") : names[part];
    sample->faces = facing > 0.0;
    sample->shadowed = facing > 0.0 && seen < 0.5 && !(seen > 0.1 && seen < 0.9);
    struct d3 ambient = mix(d3(0.54, 0.40, 0.31), d3(0.25, 0.35, 0.53), 0.5 + 0.5 * normal.y);
    ambient = d3_add(ambient, d3_times(0.5 + 0.5 * d3_dot(normal, to_sun), d3(0.22, 0.13, 0.06)));
    struct d3 light = d3_add(ambient, d3_times(seen * facing, d3(1.36, 1.00, 0.68)));
    return d3_product(colour, light);
}

static struct mirror_sample sample_13(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.what = "sky"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    double interval[2], ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 60.0;
    double t = 0.0;
    bool found = false;
    if (brute_box_interval(ray, low, high, interval)) {
        t = interval[0];
        for (int step = 0; step < MAX_STEPS && t < fmin(interval[1], ground) && !found; step++) {
            double h = distance_of(mirror_at(ray, t), NULL);
            found = h < threshold + pixel_spread * t;
            t += found ? 0.0 : h;
        }
    }
    t = found ? t : fmin(ground, 60.0);
    bool open = !found && (t >= 60.0 || mirror_at(ray, t).z < -5.2);
    struct d3 light =
        open ? sky_light(ray.direction, sun_direction()) : place_light(ray, t, found, &sample);
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 162, 37, "floor+"},    {CHAPTER, 483, 123, "floor+"},
    {CHAPTER, 63, 146, "floor+"},    {CHAPTER, 551, 120, "floor+"},
    {CHAPTER, 427, 76, "floor+"},    {CHAPTER, 505, 48, "floor+"},
    {CHAPTER, 508, 83, "floor+"},    {CHAPTER, 399, 162, "floor+"},
    {CHAPTER, 279, 20, "penumbra+"}, {CHAPTER, 293, 12, "penumbra+"},
    {CHAPTER, 121, 42, "penumbra+"}, {CHAPTER, 406, 19, "penumbra+"},
    {CHAPTER, 267, 80, "penumbra+"}, {CHAPTER, 393, 81, "penumbra+"},
    {CHAPTER, 311, 89, "penumbra+"}, {CHAPTER, 30, 17, "penumbra+"},
    {CHAPTER, 88, 320, "sky-"},      {CHAPTER, 210, 331, "sky-"},
    {CHAPTER, 87, 241, "sky-"},      {CHAPTER, 115, 238, "sky-"},
    {CHAPTER, 74, 212, "trellis-"},  {CHAPTER, 47, 182, "trellis-"},
    {CHAPTER, 172, 191, "trellis-"}, {CHAPTER, 73, 211, "trellis-"},
    {CHAPTER, 335, 106, "floor#"},   {CHAPTER, 330, 25, "floor#"},
    {CHAPTER, 342, 56, "floor#"},    {CHAPTER, 8, 22, "floor#"},
    {CHAPTER, 333, 76, "floor#"},    {CHAPTER, 365, 35, "floor#"},
    {CHAPTER, 343, 40, "floor#"},    {CHAPTER, 347, 116, "floor#"},
    {CHAPTER, 427, 173, "stairs+"},  {CHAPTER, 532, 186, "stairs+"},
    {CHAPTER, 543, 185, "stairs+"},  {CHAPTER, 545, 184, "stairs+"},
    {CHAPTER, 295, 161, "ball-"},    {CHAPTER, 382, 123, "figure-"},
    {CHAPTER, 373, 174, "figure-"},  {CHAPTER, 374, 172, "figure-"},
    {CHAPTER, 377, 185, "figure-"},  {CHAPTER, 343, 175, "parapet-"},
    {CHAPTER, 205, 173, "parapet-"}, {CHAPTER, 263, 179, "parapet-"},
    {CHAPTER, 234, 179, "parapet-"}, {CHAPTER, 608, 140, "stairs-"},
    {CHAPTER, 469, 158, "stairs-"},  {CHAPTER, 499, 171, "stairs-"},
    {CHAPTER, 514, 161, "stairs-"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    pixels_check_chapter(CHAPTER, sample_13, pixels, sizeof pixels / sizeof *pixels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
    };
    return cmocka_run_group_tests_name("scene of chapter 13", tests, gpu_setup, gpu_teardown);
}
