// test_scene_04.c - pixels of chapter 04 against colours computed in double precision, and the rows
// of its probe against the distance in double. The wheel is written down solid by solid here, so
// that the shader's folding is held against twelve solids that nobody folds.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_gpu.h"
#include "support_mirror.h"
#include "support_pixels.h"

#define STEM "04_hue_colour"

enum { WIDTH = 640, HEIGHT = 360 };
enum { STAGE = 12, MIDDLE = 13 };

static const double ring = 2.5, threshold = 0.002, blend = 0.6;
static const struct d3 low = {-3.25, -0.27, -3.25}, high = {3.25, 1.6, 3.25};
static const struct d3 to_sun = {-0.72, 0.6, 0.3487};

static struct probe probe; // too large for the stack

// ---- The scene ----

static double least(double a, double b)
{
    return a < b ? a : b;
}

static double most(double a, double b)
{
    return a > b ? a : b;
}

// Solid number i of the wheel, a ball or a die, at 30 i degrees.
static double solid(struct d3 p, int i)
{
    double angle = 30.0 * i * MIRROR_PI / 180.0, c = cos(angle), s = sin(angle);
    struct d3 q = {c * p.x + s * p.z - ring, p.y - (i % 2 == 0 ? 0.3 : 0.28), c * p.z - s * p.x};
    if (i % 2 == 0)
        return mirror_sphere(q, 0.4);
    double faces = most(fabs(q.x), most(fabs(q.y), fabs(q.z))) - 0.33;
    return most(faces, mirror_sphere(q, 0.45));
}

static double stage(struct d3 p)
{
    double out = hypot(p.x, p.z);
    double disc = most(out - 3.2, fabs(p.y + 0.12) - 0.12);
    return most(disc, 0.6 - hypot(out - ring, p.y - 0.5));
}

static double block(struct d3 p)
{
    return mirror_box(d3_sub(p, d3(0.0, 0.24, 0.0)), d3(0.9, 0.28, 0.9));
}

static double ball(struct d3 p)
{
    return mirror_sphere(d3_sub(p, d3(0.0, 0.9, 0.0)), 0.6); // at time 0
}

static double middle(struct d3 p)
{
    double h = most(blend - fabs(block(p) - ball(p)), 0.0);
    return least(block(p), ball(p)) - h * h * h / (6.0 * blend * blend);
}

static double scene_function(struct d3 p, int *nearest)
{
    double distance = stage(p);
    *nearest = STAGE;
    for (int i = 0; i < 12; i++)
        if (solid(p, i) < distance) {
            distance = solid(p, i);
            *nearest = i;
        }
    if (middle(p) < distance) {
        distance = middle(p);
        *nearest = MIDDLE;
    }
    return distance;
}

static const struct mirror_scene scene = {.function = scene_function};

// ---- Its colours ----

// The hue's definition, cut every 60 degrees, with the chapter's saturation and value.
static struct d3 colour_of(double hue)
{
    const double saturation = 0.97, value = 0.8;
    double channel[3] = {0.0, 0.0, 0.0};
    int piece = (int)(hue / 60.0);
    double up = hue / 60.0 - piece;
    channel[(piece + 1) / 2 % 3] = 1.0;
    channel[piece % 2 == 0 ? (piece / 2 + 1) % 3 : piece / 2] = piece % 2 == 0 ? up : 1.0 - up;
    for (int i = 0; i < 3; i++)
        channel[i] = value * (1.0 - saturation + saturation * channel[i]);
    return d3(channel[0], channel[1], channel[2]);
}

static struct d3 mixed(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

static struct d3 material(struct d3 p, int nearest)
{
    if (nearest == STAGE)
        return d3(0.28, 0.27, 0.265);
    if (nearest < 12)
        return colour_of(30.0 * nearest);
    double a = block(p), b = ball(p), h = most(blend - fabs(a - b), 0.0);
    double lesser = h * h / (2.0 * blend * blend);
    return mixed(colour_of(255.0), colour_of(12.0), a < b ? lesser : 1.0 - lesser);
}

static struct d3 sky(struct d3 direction)
{
    double glow = 0.5 + 0.5 * d3_dot(direction, d3(-0.5196, 0.1, -0.8485));
    return mixed(d3(0.006, 0.012, 0.026), d3(0.060, 0.140, 0.180), pow(glow, 6.0));
}

static bool hidden(struct d3 p, struct d3 normal)
{
    struct mirror_ray ray = {d3_add(p, d3_times(8.0 * threshold, normal)), to_sun};
    double t[2];
    assert_true(brute_box_interval(ray, low, high, t));
    return mirror_march(&scene, ray, 0.0, t[1], threshold, 1000).end == MIRROR_HIT;
}

static const char *name_of(int nearest, double share)
{
    if (nearest == STAGE)
        return "stage";
    if (nearest == MIDDLE)
        return share < 0.01 ? "block" : (share > 0.99 ? "ball" : "blend");
    return nearest % 2 == 0 ? "bead" : "die";
}

static double share_at(struct d3 p)
{
    double a = block(p), b = ball(p), h = most(blend - fabs(a - b), 0.0);
    return a < b ? 0.5 * h * h / blend / blend : 1.0 - 0.5 * h * h / blend / blend;
}

static struct mirror_sample sample_of(const struct mirror_eye *eye)
{
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct mirror_sample sample = {.what = "sky"};
    struct d3 light = sky(ray.direction);
    struct mirror_march march = {.end = MIRROR_PASSED};
    double t[2];
    if (brute_box_interval(ray, low, high, t))
        march = mirror_march(&scene, ray, t[0], t[1], threshold, 1000);
    if (march.end == MIRROR_HIT) {
        struct d3 p = mirror_at(ray, march.t), normal = mirror_normal(&scene, p);
        int nearest = 0;
        mirror_distance(&scene, p, &nearest);
        double facing = mirror_lambert(normal, to_sun);
        sample.what = name_of(nearest, share_at(p));
        sample.faces = facing > 0.0;
        sample.shadowed = sample.faces && hidden(p, normal);
        light = d3_times(0.5 + 0.5 * normal.y, d3(0.28, 0.335, 0.41));
        if (!sample.shadowed)
            light = d3_add(light, d3_times(facing, d3(1.25, 1.05, 0.82)));
        light = d3_product(material(p, nearest), light);
    }
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {STEM, 450, 135, "die+"},   {STEM, 430, 120, "die+"},   {STEM, 478, 190, "bead+"},
    {STEM, 488, 185, "bead+"},  {STEM, 366, 235, "blend#"}, {STEM, 300, 30, "stage+"},
    {STEM, 500, 130, "stage#"}, {STEM, 330, 70, "stage#"},  {STEM, 170, 175, "die-"},
    {STEM, 455, 233, "die-"},   {STEM, 268, 105, "die+"},   {STEM, 310, 175, "block+"},
    {STEM, 258, 208, "block+"}, {STEM, 350, 228, "blend-"}, {STEM, 300, 230, "blend+"},
    {STEM, 282, 226, "blend+"}, {STEM, 360, 220, "blend#"}, {STEM, 212, 138, "bead-"},
    {STEM, 202, 247, "bead-"},  {STEM, 370, 90, "bead+"},   {STEM, 345, 250, "ball-"},
    {STEM, 310, 270, "ball+"},  {STEM, 600, 40, "sky-"},    {STEM, 60, 300, "sky-"},
};

static void test_pixels(void **unused)
{
    (void)unused;
    const struct mirror_picture picture = {
        .name = STEM, .shader = "chapters/" STEM ".frag", .chapter = STEM, .sample = sample_of};
    const struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.15 / 255.0};
    pixels_check(&picture, &list);
}

// ---- The probe ----

// One row: its position lies on the ray, its distance is the scene's, and the next row stands that
// much farther. Eight roundings of numbers up to the distance of the eye and t.
static void check_row(struct mirror_ray ray, int row)
{
    const struct probe_step *step = &probe.step[row];
    double slack = 8.0 * MIRROR_FLOAT_ROUNDING * (d3_length(ray.origin) + (double)step->t);
    struct d3 p = mirror_at(ray, (double)step->t);
    assert_true(d3_length(d3_sub(p, d3_of(step->position))) <= slack);
    assert_true(fabs((double)step->distance - mirror_distance(&scene, p, NULL)) <= slack);
    bool last = row == probe.steps - 1;
    if (!last)
        assert_true(fabs((double)(step[1].t - step->t) - (double)step->distance) <= slack);
    assert_true(((double)step->distance < threshold) == (last && probe.end == PROBE_HIT));
}

static void check_pixel(const struct renderer_inputs *inputs, int x, int y, int *rows)
{
    struct mirror_ray ray = mirror_screen_ray(&inputs->camera, MIRROR_FOCAL_LENGTH,
                                              mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                                              mirror_screen_y(y + 0.5, HEIGHT));
    double t[2];
    assert_true(renderer_probe(&gpu.renderer, inputs, x, y, &probe));
    if (!brute_box_interval(ray, low, high, t)) {
        assert_int_equal(probe.steps, 0);
        return;
    }
    if (probe.steps == 0) // a corner of the box, cut by less than rounding
        assert_true(t[1] - t[0] < 1e-5);
    else
        assert_true(fabs((double)probe.step[0].t - t[0]) < 1e-5);
    for (int row = 0; row < probe.steps; row++)
        check_row(ray, row);
    *rows += probe.steps;
}

static void test_probe(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    int rows = 0;
    assert_true(mirror_camera(gpu.root, STEM, &inputs.camera));
    assert_true(gpu_load("chapters/" STEM ".frag"));
    for (int y = 8; y < HEIGHT; y += 24)
        for (int x = 10; x < WIDTH; x += 37)
            check_pixel(&inputs, x, y, &rows);
    print_message("# %d rows of the probe agree\n", rows);
    assert_true(rows > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels),
        cmocka_unit_test(test_probe),
    };
    return cmocka_run_group_tests_name("scene 04", tests, gpu_setup, gpu_teardown);
}
