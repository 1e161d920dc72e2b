// test_scene_17.c - the still life of chapter 17 in double precision: pixels of its picture, seen
// through glass, beside it, and on the table.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "support_glass.h"
#include "support_pixels.h"

#define CHAPTER "17_glass"

enum { HEIGHT = 360, MAX_STEPS = 80, SURFACES = 10, RINGS = 16 };

static const double threshold = 0.0004, far_away = 30.0;
static const double pixel_spread = 1.0 / (HEIGHT * MIRROR_FOCAL_LENGTH);
static const struct d3 low = {-1.95, -0.01, -1.10}, high = {1.65, 1.65, 1.15};
static const struct d3 ball_centre = {1.10, 0.502, 0.0}, lamp_colour = {1.25, 1.02, 0.78};
static const double ball_radius = 0.5;

// ---- The scene ----

static void prism_plan(struct d3 p, double plan[2])
{
    double x = p.x + 1.32, z = p.z - 0.45, c = 0.9916, s = -0.1296;
    plan[0] = c * x + s * z;
    plan[1] = s * x - c * z;
}

static double extruded(double figure, double along)
{
    double a = fmax(figure, 0.0), b = fmax(along, 0.0);
    return sqrt(a * a + b * b) + fmin(fmax(figure, along), 0.0);
}

// The nearest of the three sides, each between its corners.
static double prism(struct d3 p)
{
    const double r = 0.305, corner = sqrt(3.0) * r;
    const double at[4][2] = {{-corner, -r}, {corner, -r}, {0.0, 2.0 * r}, {-corner, -r}};
    double q[2], nearest = 9.0, outside = -9.0;
    prism_plan(p, q);
    for (int k = 0; k < 3; k++) {
        double x = at[k + 1][0] - at[k][0], y = at[k + 1][1] - at[k][1], long_ = hypot(x, y);
        double px = q[0] - at[k][0], py = q[1] - at[k][1];
        double share = mirror_clamp((px * x + py * y) / (long_ * long_));
        nearest = fmin(nearest, hypot(px - share * x, py - share * y));
        outside = fmax(outside, (y * px - x * py) / long_);
    }
    return extruded(outside < 0.0 ? -nearest : nearest, fabs(p.y - 0.322) - 0.305) - 0.015;
}

// A cone with its tip cut off, by the corners of its outline.
static double cone(double r, double y, double below, double above, double half)
{
    double way_r = above - below, way_y = 2.0 * half, from_r = r - below, from_y = y + half;
    double share =
        mirror_clamp((from_r * way_r + from_y * way_y) / (way_r * way_r + way_y * way_y));
    double wall = hypot(from_r - share * way_r, from_y - share * way_y);
    double lid = hypot(fmax(r - above, 0.0), y - half),
           floor_ = hypot(fmax(r - below, 0.0), y + half);
    bool inside = fabs(y) < half && way_y * from_r - way_r * from_y < 0.0;
    return (inside ? -1.0 : 1.0) * fmin(wall, fmin(lid, floor_));
}

static double tumbler(struct d3 p)
{
    double r = hypot(p.x + 0.10, p.z + 0.40), y = p.y - 0.802;
    return fmax(cone(r, y, 0.50, 0.58, 0.77) - 0.03, -cone(r, y - 0.30, 0.455, 0.54, 0.8));
}

static double distance_of(struct d3 p)
{
    double ball = d3_length(d3_sub(p, ball_centre)) - ball_radius;
    return fmin(tumbler(p), fmin(prism(p), ball));
}

static struct d3 normal_at(struct d3 p)
{
    double g[3];
    for (int k = 0; k < 3; k++) {
        struct d3 step =
            d3(k == 0 ? threshold : 0.0, k == 1 ? threshold : 0.0, k == 2 ? threshold : 0.0);
        g[k] = distance_of(d3_add(p, step)) - distance_of(d3_sub(p, step));
    }
    return d3_unit(d3(g[0], g[1], g[2]));
}

static double index_at(struct d3 p)
{
    return p.x < -0.72 ? glass_index(1.6894, 0.01341, 0.55) : glass_index(1.5046, 0.00420, 0.55);
}

static struct d3 left_of(struct d3 p, double way)
{
    double k = p.x < -0.72 || p.x > 0.56 ? 0.0 : way;
    return d3(exp(-0.25 * k), exp(-0.9 * k), exp(-2.4 * k));
}

// ---- The room ----

static struct d3 to_lamp(void)
{
    double azimuth = 28.0 * MIRROR_PI / 180.0;
    return d3_unit(d3(cos(azimuth), 0.5, -sin(azimuth)));
}

static struct d3 mix(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

static struct d3 surroundings(struct d3 d)
{
    double depth = fmax(-d.z, 0.05), off = hypot(d.x / depth, (d.y - 0.06) / depth);
    double glow = (1.0 - mirror_smoothstep(0.0, 0.75, off)) * mirror_smoothstep(0.0, 0.3, -d.z);
    double left = mirror_smoothstep(0.72, 0.78, -d.x) * mirror_smoothstep(0.04, 0.10, d.y) *
                  (1.0 - mirror_smoothstep(0.55, 0.60, d.y));
    double right = mirror_smoothstep(0.90, 0.93, d.x) * mirror_smoothstep(0.06, 0.12, d.y);
    double lamp = mirror_smoothstep(0.9975, 0.9985, d3_dot(d, to_lamp()));
    struct d3 above = d3_add(d3(0.012, 0.026, 0.055), d3_times(glow, d3(0.34, 0.09, 0.06)));
    above = d3_add(above, d3_times(glow * glow * glow, d3(0.80, 0.62, 0.36)));
    above = d3_add(above, d3_times(left, d3(0.36, 0.48, 0.62)));
    above = d3_add(above, d3_times(right, d3(1.1, 0.85, 0.6)));
    above = d3_add(above, d3_times(4.0 * lamp, lamp_colour));
    return mix(d3_times(0.35, d3(0.045, 0.060, 0.080)), above, mirror_smoothstep(-0.02, 0.02, d.y));
}

// ---- The table ----

static double coverage(double inside, double width)
{
    return mirror_clamp(inside / (width + 0.001) + 0.5);
}

// By the chord that the straight ray cuts out of each solid, in steps that are short.
static struct d3 straight_through(struct mirror_ray ray, double from, double to)
{
    double share = 1.0, inside = 0.0, t = from, before = 1e6, stride = 1e6, deepest = from,
           lowest = 0.0;
    for (int step = 0; step < MAX_STEPS && t < to; step++) {
        double d = distance_of(mirror_at(ray, t)), part = mirror_clamp(d / (d - before));
        bool crossed = (before < 0.0) != (d < 0.0);
        if (crossed)
            share *= 1.0 - glass_fresnel(mirror_clamp(fabs(d - before) / stride), 1.0 / 1.52);
        inside += stride * (crossed ? (d < 0.0 ? part : 1.0 - part) : (d < 0.0 ? 1.0 : 0.0));
        deepest = d < lowest ? t : deepest;
        lowest = fmin(lowest, d);
        before = d;
        stride = fmax(fabs(d), 0.015);
        t += stride;
    }
    return d3_times(share, left_of(mirror_at(ray, deepest), inside));
}

static double disc_area(double radius, double width)
{
    double reach = radius + 0.5 * width;
    return radius < 0.5 * width ? pow(reach, 3.0) / (3.0 * width)
                                : radius * radius + width * width / 12.0;
}

static double caustic(double z, double r)
{
    double width = fmax(0.05 * z, 0.001), light = 0.0, before = 0.0;
    if (z <= 0.0 || r >= fmax(ball_radius, 2.5 * z) + width)
        return 0.0;
    for (int k = 1; k <= RINGS; k++) {
        double sine = 0.96 * k / RINGS, less = 0.96 * (k - 1) / RINGS, i = asin(sine);
        double turn = 2.0 * (i - asin(sine / 1.52));
        double after = (ball_radius * sine - z * sin(turn)) / fmax(cos(turn), 0.05);
        double passes = (1.0 - glass_fresnel(cos(i), 1.0 / 1.52)) *
                        (1.0 - glass_fresnel(sqrt(1.0 - less * less), 1.0 / 1.52));
        double a = before * after > 0.0 ? fmin(fabs(before), fabs(after)) : 0.0;
        double b = fmax(fabs(before), fabs(after));
        double ring = disc_area(b, width) - (a > 0.0 ? disc_area(a, width) : 0.0);
        double lit = coverage(b - r, width) - (a > 0.0 ? coverage(a - r, width) : 0.0);
        if (z > ball_radius * cos(turn - i)) // the ring has left the ball
            light += lit * passes * 0.25 * (sine * sine - less * less) / fmax(ring, 2.5e-7);
        before = after;
    }
    return light;
}

static struct d3 lamp_light(struct d3 p, struct mirror_sample *sample)
{
    struct d3 lamp = to_lamp(), from = d3_sub(p, ball_centre);
    struct mirror_ray ray = {d3(p.x, p.y + 0.001, p.z), lamp};
    double interval[2] = {0.0, 0.0}, along = d3_dot(from, lamp);
    double r = d3_length(d3_sub(from, d3_times(along, lamp)));
    struct d3 straight = d3(1.0, 1.0, 1.0);
    if (brute_box_interval(ray, low, high, interval))
        straight = straight_through(ray, interval[0], interval[1]);
    double kept = along < 0.0 ? 1.0 - coverage(ball_radius - r, 0.02) : 1.0;
    sample->shadowed = kept < 0.5 || straight.x < 0.9;
    struct d3 light = d3_times(kept, straight);
    double gathered = caustic(-along, r);
    light = d3_add(light, d3(gathered, gathered, gathered));
    return d3_times(6.0 * lamp.y, d3_product(light, lamp_colour));
}

// One line of the pattern.
static double line(double x, double width)
{
    double share = coverage(0.0125 - fabs(x - floor(x) - 0.5), width);
    return share + mirror_smoothstep(0.4, 1.0, width) * (0.025 - share);
}

// Where the beam is: 1 before the prism, 2 behind, where the colours are not computed here.
static int beam_at(struct d3 p)
{
    double q[2],
        green = sqrt((pow(glass_index(1.6894, 0.01341, 0.55), 2.0) - 0.0196) / (1.0 - 0.0196));
    prism_plan(p, q);
    double entering = asin(0.5 * green), angle = entering - MIRROR_PI / 6.0;
    double x = q[0] + 0.32 * cos(MIRROR_PI / 6.0), y = q[1] - 0.16,
           aside = cos(angle) * y - sin(angle) * x;
    if (0.5 * y - cos(MIRROR_PI / 6.0) * x > 0.0)
        return fabs(aside) < 0.02 ? 1 : (fabs(aside) < 0.06 ? 3 : 0);
    x = q[0] - 0.32 * cos(MIRROR_PI / 6.0);
    aside = cos(angle) * y + sin(angle) * x;
    return fabs(aside) < 0.2 * (cos(angle) * x - sin(angle) * y) + 0.12 ? 2 : 0;
}

static struct d3 world(struct mirror_ray ray, double come, struct mirror_sample *sample, bool first)
{
    double t = ray.direction.y < 0.0 ? fmin(-ray.origin.y / ray.direction.y, far_away) : far_away;
    struct d3 p = mirror_at(ray, t), d = ray.direction;
    struct d3 room = surroundings(d3_unit(d3(d.x, fmax(d.y, 0.03), d.z)));
    if (t >= far_away)
        return room;
    struct mirror_sample there = {.what = "table"};
    double width = 2.0 * pixel_spread * (come + t) / 0.6;
    double pattern = fmax(line(p.x / 0.6, width * (1.0 + fabs(d.x / d.y))),
                          line(p.z / 0.6, width * (1.0 + fabs(d.z / d.y))));
    struct d3 light = d3_add(d3(0.16, 0.20, 0.30),
                             d3_times(exp(-0.1 * (p.x * p.x + p.z * p.z)), lamp_light(p, &there)));
    int beam = beam_at(p);
    if (beam == 1)
        light = d3_add(light, d3(8.0, 8.0, 8.0));
    static const char *const names[] = {"table", "beam", "colours", "edge"};
    there.what = names[beam];
    if (first)
        *sample = there;
    else if (beam > 1)
        sample->what = "through glass, colours";
    struct d3 colour = d3_times(1.0 + 2.2 * pattern, d3(0.045, 0.060, 0.080));
    return mix(d3_product(colour, light), room, mirror_smoothstep(2.5, 12.0, hypot(p.x, p.z)));
}

// ---- From surface to surface ----

static struct mirror_sample sample_17(const struct mirror_eye *eye)
{
    static const char *const parts[] = {"prism", "tumbler", "ball"};
    struct mirror_sample sample = {.what = "room"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct d3 light = d3(0.0, 0.0, 0.0), share = d3(1.0, 1.0, 1.0);
    double side = 1.0, come = 0.0, t;
    int met = 0;
    for (; met < SURFACES; met++) {
        double interval[2];
        double ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : far_away;
        if (!brute_box_interval(ray, low, high, interval))
            break;
        const double from_to[2] = {side > 0.0 ? interval[0] : 0.0, fmin(interval[1], ground)};
        if (!glass_march(distance_of, ray, side, from_to, threshold, MAX_STEPS, &t))
            break;
        struct d3 p = mirror_at(ray, t), normal = normal_at(p), bent;
        double facing = mirror_clamp(-side * d3_dot(normal, ray.direction));
        double eta = side > 0.0 ? 1.0 / index_at(p) : index_at(p),
               mirrored = glass_fresnel(facing, eta);
        if (side < 0.0)
            share = d3_product(share, left_of(p, t));
        struct d3 away = glass_reflect(ray.direction, normal);
        bool back = !glass_refract(ray.direction, d3_times(side, normal), eta, &bent);
        if (!back) {
            light = d3_add(light, d3_product(share, d3_times(mirrored, surroundings(away))));
            share = d3_times(1.0 - mirrored, share);
        }
        if (met == 0)
            sample.what = parts[p.x < -0.72 ? 0 : (p.x > 0.56 ? 2 : 1)];
        come += t;
        ray = glass_leaving(p, normal, back ? away : bent, 2.5 * threshold);
        side = back ? side : -side;
    }
    if (met < SURFACES)
        light = d3_add(light, d3_product(share, world(ray, come, &sample, met == 0)));
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 162, 222, "table-"},   {CHAPTER, 500, 98, "table-"},
    {CHAPTER, 26, 216, "table-"},    {CHAPTER, 290, 320, "table-"},
    {CHAPTER, 516, 233, "table-"},   {CHAPTER, 97, 290, "table-"},
    {CHAPTER, 562, 130, "table-"},   {CHAPTER, 184, 344, "room-"},
    {CHAPTER, 482, 99, "table-"},    {CHAPTER, 267, 59, "table#"},
    {CHAPTER, 340, 237, "tumbler-"}, {CHAPTER, 217, 338, "room-"},
    {CHAPTER, 550, 263, "table-"},   {CHAPTER, 84, 325, "room-"},
    {CHAPTER, 136, 354, "room-"},    {CHAPTER, 90, 44, "table#"},
    {CHAPTER, 314, 332, "room-"},    {CHAPTER, 78, 49, "table#"},
    {CHAPTER, 371, 130, "table#"},   {CHAPTER, 360, 339, "room-"},
    {CHAPTER, 289, 294, "tumbler-"}, {CHAPTER, 319, 233, "tumbler-"},
    {CHAPTER, 338, 220, "tumbler-"}, {CHAPTER, 419, 208, "ball-"},
    {CHAPTER, 290, 296, "tumbler-"}, {CHAPTER, 238, 66, "table#"},
    {CHAPTER, 329, 289, "tumbler-"}, {CHAPTER, 65, 89, "table#"},
    {CHAPTER, 434, 170, "ball-"},    {CHAPTER, 248, 157, "table#"},
    {CHAPTER, 450, 147, "ball-"},    {CHAPTER, 413, 182, "ball-"},
    {CHAPTER, 147, 144, "prism-"},   {CHAPTER, 294, 294, "tumbler-"},
    {CHAPTER, 329, 266, "tumbler-"}, {CHAPTER, 324, 239, "tumbler-"},
    {CHAPTER, 218, 126, "prism-"},   {CHAPTER, 277, 251, "tumbler-"},
    {CHAPTER, 297, 179, "tumbler-"}, {CHAPTER, 111, 80, "prism-"},
    {CHAPTER, 449, 203, "ball-"},    {CHAPTER, 163, 179, "prism-"},
    {CHAPTER, 198, 123, "prism-"},   {CHAPTER, 103, 104, "prism-"},
    {CHAPTER, 477, 173, "ball-"},    {CHAPTER, 155, 116, "prism-"},
    {CHAPTER, 221, 124, "prism-"},   {CHAPTER, 423, 130, "ball-"},
    {CHAPTER, 392, 190, "ball-"},    {CHAPTER, 408, 170, "ball-"},
    {CHAPTER, 189, 109, "prism-"},   {CHAPTER, 220, 130, "prism-"},
    {CHAPTER, 112, 82, "prism-"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    const struct mirror_picture picture = {.name = CHAPTER,
                                           .shader = "chapters/" CHAPTER ".frag",
                                           .chapter = CHAPTER,
                                           .sample = sample_17};
    const struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.2 / 255.0};
    pixels_check(&picture, &list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
    };
    return cmocka_run_group_tests_name("scene of chapter 17", tests, gpu_setup, gpu_teardown);
}
