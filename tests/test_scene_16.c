// test_scene_16.c - the pier of chapter 16 in double precision: how many steps a ray takes without
// the means, and what it sees with them.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_pixels.h"

#define CHAPTER "16_fewer_steps"

enum { HEIGHT = 360, MAX_STEPS = 256 };

static const double threshold = 0.0005, sea = -1.1, far = 150.0, twist = 3.0, reach = 0.28;

// ---- The scene ----

static double box(struct d3 p, double x, double y, double z, double a, double b, double c)
{
    return brute_box(d3_sub(p, d3(x, y, z)), d3(a, b, c));
}

// The nearest of copies along z, one by one.
static double row(struct d3 p, double x, double y, double z, double period, int first, int last,
                  double width, double height)
{
    double nearest = HUGE_VAL;
    for (int i = first; i <= last; i++)
        nearest = fmin(nearest, box(p, x, y, z + period * i, width, height, width));
    return nearest;
}

static double pier(struct d3 p)
{
    double deck = box(p, 0.0, -0.06, -16.5, 1.4, 0.06, 24.0);
    double rails = fmin(box(p, 1.3, 0.95, -16.5, 0.045, 0.025, 24.0),
                        box(p, 1.3, 0.5, -16.5, 0.012, 0.012, 24.0));
    double bars = fmin(row(p, 1.3, 0.46, -16.5, 1.5, -16, 16, 0.03, 0.46),
                       row(p, 1.3, -0.7, -16.5, 4.5, -5, 5, 0.08, 0.6));
    double masts = row(p, 1.3, 1.3, -14.25, 9.0, -2, 2, 0.025, 1.3);
    for (int i = -2; i <= 2; i++)
        masts = fmin(masts, d3_length(d3_sub(p, d3(1.3, 2.75, -14.25 + 9.0 * i))) - 0.15);
    return fmin(fmin(deck, rails), fmin(bars, masts));
}

static double pavilion(struct d3 p)
{
    struct d3 q = d3(p.x, p.y, p.z + 44.5);
    double nearest =
        fmin(box(q, 0.0, -0.06, 0.0, 4.2, 0.06, 4.2), box(q, 0.0, 6.3, 0.0, 0.5, 0.6, 0.5));
    for (int i = -3; i <= 3; i++)
        for (int side = -1; side <= 1; side += 2)
            nearest = fmin(nearest, box(q, 1.2 * i, 1.6, 3.6 * side, 0.08, 1.7, 0.08));
    double aside = fmax(q.x, fabs(q.z));
    double roof = fmax(0.83 * (aside - 4.2 + 1.2 * (q.y - 3.3)) / 1.3, 3.3 - q.y);
    return fmin(nearest, fmax(roof, q.y - 6.0));
}

static double poles(struct d3 p)
{
    double u = twist * reach, stretch = 0.5 * (u + sqrt(u * u + 4.0)), nearest = HUGE_VAL;
    for (int i = -5; i <= 0; i++) {
        struct d3 q = d3(p.x - 4.3, p.y - 0.2, p.z - 7.0 * i);
        double across = hypot(q.x, q.z), c = cos(twist * q.y), s = sin(twist * q.y);
        double round = fmax(across - 0.17, fabs(q.y) - 1.6);
        struct d3 turned = d3(c * q.x + s * q.z, q.y, c * q.z - s * q.x);
        double pole = mirror_box(turned, d3(0.12, 1.6, 0.12)) / stretch;
        nearest = fmin(nearest, across < reach ? fmax(pole, round) : round);
        nearest = fmin(nearest, d3_length(d3(q.x, q.y - 1.72, q.z)) - 0.16);
    }
    return nearest;
}

static double distance_of(struct d3 p)
{
    struct d3 q = d3(fabs(p.x), p.y, p.z);
    return fmin(fmin(pier(q), pavilion(q)), poles(q));
}

// ---- The steps as a colour ----

static struct d3 step_colour(int steps)
{
    static const struct d3 colours[] = {{0.05, 0.04, 0.15},
                                        {0.24, 0.16, 0.43},
                                        {0.62, 0.27, 0.46},
                                        {0.94, 0.55, 0.37},
                                        {1.00, 0.95, 0.72}};
    double x = fmin(steps / 16.0, 3.999);
    int i = (int)x;
    return d3_add(d3_times(1.0 - (x - i), colours[i]), d3_times(x - i, colours[i + 1]));
}

// The left side of the divider: the plain march, the water by its formula.
static struct mirror_sample sample_16(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.what = "sky"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    double ground = ray.direction.y < 0.0 ? (sea - ray.origin.y) / ray.direction.y : 1e6;
    double last = fmin(ground, far), t = 0.0;
    int steps = 0;
    bool found = false;
    while (!found && t < last && steps < MAX_STEPS) {
        double h = distance_of(mirror_at(ray, t));
        steps++;
        found = h < threshold;
        t += found ? 0.0 : h;
    }
    struct d3 p = mirror_at(ray, t);
    if (!found)
        sample.what = ground < far ? "water" : "sky";
    else
        sample.what =
            fabs(p.x) > 3.5 ? "pole" : (p.y < 0.001 && fabs(p.x) < 1.25 ? "walk" : "pier");
    sample.colour = step_colour(steps);
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 151, 303, "sky-"},   {CHAPTER, 210, 351, "sky-"},  {CHAPTER, 74, 207, "sky-"},
    {CHAPTER, 89, 274, "sky-"},    {CHAPTER, 228, 267, "sky-"},  {CHAPTER, 273, 238, "sky-"},
    {CHAPTER, 55, 246, "sky-"},    {CHAPTER, 254, 216, "sky-"},  {CHAPTER, 220, 309, "sky-"},
    {CHAPTER, 251, 324, "sky-"},   {CHAPTER, 37, 151, "water-"}, {CHAPTER, 57, 20, "water-"},
    {CHAPTER, 153, 166, "water-"}, {CHAPTER, 4, 143, "water-"},  {CHAPTER, 24, 106, "water-"},
    {CHAPTER, 174, 164, "water-"}, {CHAPTER, 96, 88, "water-"},  {CHAPTER, 83, 54, "water-"},
    {CHAPTER, 91, 8, "water-"},    {CHAPTER, 24, 129, "water-"}, {CHAPTER, 191, 7, "walk-"},
    {CHAPTER, 282, 115, "walk-"},  {CHAPTER, 239, 91, "walk-"},  {CHAPTER, 176, 17, "walk-"},
    {CHAPTER, 299, 163, "walk-"},  {CHAPTER, 304, 163, "walk-"}, {CHAPTER, 311, 61, "walk-"},
    {CHAPTER, 253, 75, "walk-"},   {CHAPTER, 293, 119, "walk-"}, {CHAPTER, 211, 27, "walk-"},
    {CHAPTER, 171, 126, "pier-"},  {CHAPTER, 37, 65, "pier-"},   {CHAPTER, 168, 122, "pier-"},
    {CHAPTER, 32, 74, "pier-"},    {CHAPTER, 45, 88, "pier-"},   {CHAPTER, 33, 78, "pier-"},
    {CHAPTER, 199, 313, "pier-"},  {CHAPTER, 199, 107, "pier-"}, {CHAPTER, 243, 141, "pier-"},
    {CHAPTER, 310, 216, "pier-"},  {CHAPTER, 118, 101, "pole-"}, {CHAPTER, 119, 84, "pole-"},
    {CHAPTER, 116, 79, "pole-"},   {CHAPTER, 117, 96, "pole-"},  {CHAPTER, 213, 190, "pole-"},
    {CHAPTER, 117, 85, "pole-"},   {CHAPTER, 215, 172, "pole-"}, {CHAPTER, 118, 79, "pole-"},
    {CHAPTER, 113, 166, "pole-"},  {CHAPTER, 120, 96, "pole-"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    const struct mirror_picture picture = {.name = CHAPTER,
                                           .shader = "chapters/" CHAPTER ".frag",
                                           .chapter = CHAPTER,
                                           .sample = sample_16};
    const struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.1 / 255.0};
    pixels_check(&picture, &list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
    };
    return cmocka_run_group_tests_name("scene of chapter 16", tests, gpu_setup, gpu_teardown);
}
