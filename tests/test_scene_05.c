// test_scene_05.c - chapter 05's picture against its scene and light computed once more, in double
// precision; and the probe's table against that scene, step by step.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_pixels.h"

#define STEM   "05_transforms"
#define SHADER "chapters/" STEM ".frag"
#define TIME   1.5 // seconds, so that the waves have moved

enum { SEA, RING, BALL, CRATE };

static const char *const names[] = {"sea", "ring", "ball", "crate"};
static const double amplitude[3] = {0.060, 0.036, 0.024};
static const double wave[3][2] = {{0.45, 1.20}, {-1.10, 1.70}, {1.90, 1.60}};
static const double speed[3] = {3.55, 4.46, 4.94};
static const struct d3 sun_colour = {2.6, 1.6, 0.7};

static struct probe probe; // too large for the stack

// ---- Where things are ----

static struct d3 about_x(double a, struct d3 v)
{
    return d3(v.x, cos(a) * v.y - sin(a) * v.z, sin(a) * v.y + cos(a) * v.z);
}

static struct d3 about_y(double a, struct d3 v)
{
    return d3(cos(a) * v.x + sin(a) * v.z, v.y, cos(a) * v.z - sin(a) * v.x);
}

static struct d3 about_z(double a, struct d3 v)
{
    return d3(cos(a) * v.x - sin(a) * v.y, sin(a) * v.x + cos(a) * v.y, v.z);
}

static double sea_height(double x, double z, double slope[2])
{
    double height = 0.0;
    slope[0] = slope[1] = 0.0;
    for (int i = 0; i < 3; i++) {
        double phase = wave[i][0] * x + wave[i][1] * z + speed[i] * TIME;
        height += amplitude[i] * sin(phase);
        slope[0] += amplitude[i] * wave[i][0] * cos(phase);
        slope[1] += amplitude[i] * wave[i][1] * cos(phase);
    }
    return height;
}

// A thing: where it floats, and how it lies in still water, turned about x, z and y in an order of
// its own.
struct thing {
    double x, z, draught;
    double turn[3]; // the angles of three rotations, the last one first
    char order[3];  // and their axes
};

static const struct thing things[] = {
    [RING] = {-1.2, 1.2, 0.16, {-1.35, 0.22, 0.5}, {'x', 'z', 'y'}},
    [BALL] = {0.95, -1.3, 0.18, {-0.35, 0.4, 0.0}, {'z', 'y', 'y'}},
    [CRATE] = {3.0, -2.8, 0.12, {0.3, 0.5, 0.7}, {'z', 'x', 'y'}},
};

// The point as a thing sees it: every motion undone, the last one first.
static struct d3 seen_from(int which, struct d3 p)
{
    const struct thing *thing = &things[which];
    double slope[2], height = sea_height(thing->x, thing->z, slope);
    p = d3_sub(p, d3(thing->x, height + thing->draught, thing->z));
    p = about_x(slope[1], about_z(-slope[0], p));
    for (int i = 2; i >= 0; i--) {
        double back = -thing->turn[i];
        p = thing->order[i] == 'x' ? about_x(back, p)
                                   : (thing->order[i] == 'y' ? about_y(back, p) : about_z(back, p));
    }
    return p;
}

static struct d3 ring_point(struct d3 p)
{
    struct d3 q = d3_times(1.0 / 0.66, seen_from(RING, p));
    return about_y(0.6 * q.y, q);
}

static double scene_distance(struct d3 p, int *nearest)
{
    double slope[2], u = 0.6 * 1.5, stretch = 0.5 * (u + sqrt(u * u + 4.0));
    struct d3 q = ring_point(p);
    double away = d3_length(q) - 1.3, ring = hypot(hypot(q.x, q.y) - 1.0, q.z) - 0.26;
    double distance[4];
    distance[SEA] = (p.y - sea_height(p.x, p.z, slope)) / sqrt(1.0 + 0.21 * 0.21);
    distance[RING] = 0.66 * (away > 0.2 ? away : ring / stretch);
    distance[BALL] = mirror_sphere(seen_from(BALL, p), 0.62);
    distance[CRATE] = mirror_box(seen_from(CRATE, p), d3(0.42, 0.42, 0.42)) - 0.02;
    return mirror_nearest(distance, 4, nearest);
}

static const struct mirror_scene scene = {.function = scene_distance};

// ---- Light ----

static struct d3 mixed(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

static struct d3 to_sun(void)
{
    return d3_unit(about_y(25.0 * MIRROR_PI / 180.0, d3(0.0, 0.18, -1.0)));
}

static struct d3 sky_light(struct d3 direction)
{
    double low = 1.0 / (1.0 + 5.0 * fmax(direction.y, 0.0));
    double sun = fmax(d3_dot(direction, to_sun()), 0.0);
    struct d3 sky = mixed(d3(0.035, 0.13, 0.36), d3(0.38, 0.42, 0.50), low * low);
    sky = d3_add(sky, d3_times(pow(sun, 8.0) * low * low, d3(0.62, 0.25, 0.04)));
    return d3_add(sky, d3_times(pow(sun, 32.0), d3(0.55, 0.36, 0.14)));
}

static struct d3 paint_of(int which, struct d3 p)
{
    struct d3 q = ring_point(p), ball = seen_from(BALL, p), crate = seen_from(CRATE, p);
    double cosine2 = q.x * q.x / (q.x * q.x + q.y * q.y);
    if (which == RING)
        return mixed(d3(0.75, 0.02, 0.01), d3(0.8, 0.8, 0.8),
                     mirror_smoothstep(0.34, 0.36, fabs(cosine2 - 0.5)));
    if (which == BALL)
        return mixed(d3(0.03, 0.03, 0.03), d3(0.95, 0.55, 0.02),
                     mirror_smoothstep(0.06, 0.07, fabs(ball.y - 0.1)));
    double rim = mirror_smoothstep(0.34, 0.35, fabs(crate.x)) +
                 mirror_smoothstep(0.34, 0.35, fabs(crate.y)) +
                 mirror_smoothstep(0.34, 0.35, fabs(crate.z));
    return rim >= 1.5 ? d3(0.42, 0.24, 0.10) : d3(0.30, 0.14, 0.05);
}

// The ripples' phases and what they add to the slope.
static const double bent[4][3] = {
    {1.3, -1.9, 0.0}, {2.1, 1.1, 0.0}, {-1.7, 2.3, 0.0}, {0.9, 2.7, 0.0}};
static const double ripple[4][3] = {
    {5.1, 4.3, 6.8}, {-6.3, 7.7, 9.9}, {9.7, 5.9, 10.6}, {3.3, -12.1, 11.1}};
static const double ripple_slope[4][2] = {{0.7, 0.6}, {-0.6, 0.7}, {0.8, 0.5}, {0.2, -0.9}};

static struct d3 water_normal(double x, double z, double t)
{
    double slope[2], flatter = 1.0 + 0.006 * t * t;
    sea_height(x, z, slope);
    for (int i = 0; i < 4; i++) {
        double phase = ripple[i][0] * x + ripple[i][1] * z + ripple[i][2] * TIME;
        double small = 0.03 * cos(phase + 1.5 * sin(bent[i][0] * x + bent[i][1] * z));
        slope[0] += small * ripple_slope[i][0];
        slope[1] += small * ripple_slope[i][1];
    }
    return d3_unit(d3(-slope[0] / flatter, 1.0, -slope[1] / flatter));
}

// What a mirror of this normal shows, the things aside, and its share.
static struct d3 image_in(struct d3 mirrored, bool sky)
{
    double sun = fmax(d3_dot(mirrored, to_sun()), 0.0);
    double glare = sky ? 4.0 * mirror_smoothstep(0.9997, 0.9998, sun) : 12.0 * pow(sun, 260.0);
    return d3_add(sky_light(mirrored), d3_times(glare, sun_colour));
}

static double mirror_share(struct d3 normal, struct d3 direction)
{
    return 0.02 + 0.98 * pow(1.0 - fmax(-d3_dot(normal, direction), 0.0), 5.0);
}

static struct d3 mirrored_in(struct d3 normal, struct d3 direction)
{
    struct d3 m = d3_sub(direction, d3_times(2.0 * d3_dot(normal, direction), normal));
    return d3(m.x, fabs(m.y), m.z);
}

// Does a ray from the surface meet a thing?
static struct mirror_march onward(struct d3 p, struct d3 normal, struct d3 direction, struct d3 *q,
                                  int *which)
{
    struct mirror_ray ray = {d3_add(p, d3_times(0.03, normal)), direction};
    struct mirror_march march = mirror_reach(&scene, ray, 0.0, 12.0);
    *q = mirror_at(ray, march.t);
    scene_distance(*q, which);
    return march;
}

static struct d3 thing_light(int which, struct d3 p, struct d3 direction,
                             struct mirror_sample *sample)
{
    struct d3 normal = mirror_normal(&scene, p), q;
    int met;
    double facing = mirror_lambert(normal, to_sun());
    sample->faces = facing > 0.0;
    sample->shadowed = sample->faces && onward(p, normal, to_sun(), &q, &met).end == MIRROR_HIT;
    struct d3 light = mixed(d3(0.05, 0.08, 0.10), d3(0.30, 0.36, 0.46), 0.5 + 0.5 * normal.y);
    if (!sample->shadowed)
        light = d3_add(light, d3_times(facing, sun_colour));
    struct d3 image = image_in(mirrored_in(normal, direction), false);
    return d3_add(d3_product(paint_of(which, p), light),
                  d3_times(0.6 * mirror_share(normal, direction), image));
}

static struct d3 water_light(struct d3 p, double t, struct d3 direction,
                             struct mirror_sample *sample)
{
    struct d3 normal = water_normal(p.x, p.z, t), mirrored = mirrored_in(normal, direction), q;
    struct d3 image = image_in(mirrored, false);
    int met;
    sample->shadowed = onward(p, normal, mirrored, &q, &met).end == MIRROR_HIT && met != SEA;
    if (sample->shadowed) {
        sample->what = "mirrored";
        image = d3_times(0.6, paint_of(met, q));
    }
    struct d3 deep =
        d3_add(d3(0.004, 0.040, 0.060), d3_times(fmax(p.y / 0.12, 0.0), d3(0.0, 0.07, 0.06)));
    struct d3 water = mixed(deep, image, mirror_share(normal, direction));
    return mixed(sky_light(d3(direction.x, 0.0, direction.z)), water, exp(-0.012 * t));
}

static struct mirror_sample see(const struct mirror_eye *eye)
{
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct mirror_sample sample = {.what = "sky"};
    struct d3 light = image_in(ray.direction, true);
    struct mirror_march march = {.end = MIRROR_PASSED};
    if (ray.direction.y < 0.05)
        march = mirror_reach(&scene, ray, 0.0, 60.0);
    struct d3 p = mirror_at(ray, march.t);
    int which = SEA;
    scene_distance(p, &which);
    bool flat = march.end != MIRROR_HIT || (which == SEA && p.z < -10.0);
    if (flat && ray.direction.y < -0.0015) { // beyond the box of the waves
        double t = -ray.origin.y / ray.direction.y;
        sample.what = "offing";
        light = water_light(mirror_at(ray, t), t, ray.direction, &sample);
    } else if (!flat) {
        sample.what = names[which];
        light = which == SEA ? water_light(p, march.t, ray.direction, &sample)
                             : thing_light(which, p, ray.direction, &sample);
    }
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

static const struct mirror_picture picture = {STEM, SHADER, STEM, TIME, see};

// The march ends up to 0.004 before the surface. That turns what a curved or a grazed mirror shows
// by more than these pixels allow in the sun's path and on the ring's rim: none of them stands
// there.
static const struct pixel pixels[] = {
    {STEM, 348, 156, "ball-"},     {STEM, 372, 180, "ball-"},     {STEM, 378, 156, "ball-"},
    {STEM, 396, 174, "ball-"},     {STEM, 444, 168, "crate-"},    {STEM, 456, 192, "crate-"},
    {STEM, 480, 174, "crate-"},    {STEM, 432, 150, "mirrored#"}, {STEM, 438, 126, "mirrored#"},
    {STEM, 480, 150, "mirrored#"}, {STEM, 522, 204, "offing-"},   {STEM, 546, 222, "offing-"},
    {STEM, 174, 96, "ring-"},      {STEM, 192, 138, "ring-"},     {STEM, 240, 96, "ring-"},
    {STEM, 282, 120, "ring-"},     {STEM, 42, 198, "sea-"},       {STEM, 60, 144, "sea-"},
    {STEM, 126, 180, "sea-"},      {STEM, 360, 6, "sea-"},        {STEM, 402, 192, "sea-"},
    {STEM, 360, 240, "sky-"},      {STEM, 396, 276, "sky-"},      {STEM, 444, 294, "sky-"},
    {STEM, 606, 276, "sky-"},
};

static void test_pixels(void **unused)
{
    (void)unused;
    const struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.5 / 255.0};
    pixels_check(&picture, &list);
}

// ---- The probe ----

// A ray is marched in double beside the table, each step from the table's own t. Positions and
// distances are off by roundings of numbers no larger than 20: 1e-5 is generous.
static void test_probe(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = {.width = 640, .height = 360, .time = TIME, .samples = 1};
    assert_true(mirror_camera(gpu.root, STEM, &inputs.camera));
    assert_true(gpu_load(SHADER));
    int steps = 0, ends[4] = {0};
    double worst = 0.0;
    for (int y = 8; y < 240; y += 16)
        for (int x = 10; x < 640; x += 37) {
            struct mirror_ray ray = mirror_screen_ray(&inputs.camera, MIRROR_FOCAL_LENGTH,
                                                      mirror_screen_x(x + 0.5, 640, 360),
                                                      mirror_screen_y(y + 0.5, 360));
            assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
            ends[probe.end]++;
            for (int i = 0; i < probe.steps; i++, steps++) {
                const struct probe_step *step = &probe.step[i];
                struct d3 p = mirror_at(ray, (double)step->t);
                worst = fmax(worst, d3_length(d3_sub(p, d3_of(step->position))));
                double f = mirror_distance(&scene, p, NULL);
                worst = fmax(worst, fabs((double)step->distance - f));
                bool last = i == probe.steps - 1, hit = step->distance < 0.004f;
                assert_true(last ? hit == (probe.end == PROBE_HIT) : !hit);
                if (!last)
                    worst = fmax(worst, fabs((double)(step[1].t - step->t - step->distance)));
            }
        }
    print_message("# %d steps, off by at most %.2g; %d hits, %d passed, %d gave up\n", steps, worst,
                  ends[PROBE_HIT], ends[PROBE_PASSED], ends[PROBE_GAVE_UP]);
    assert_true(worst < 1e-5 && steps > 1000 && ends[PROBE_HIT] > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels),
        cmocka_unit_test(test_probe),
    };
    return cmocka_run_group_tests_name("scene_05", tests, gpu_setup, gpu_teardown);
}
