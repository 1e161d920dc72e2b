// test_scene_12.c - chapter 12 in double precision: the rough stones are marched without a hole,
// with how much slack, and pixels of sky and ground.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_noise.h"
#include "support_pixels.h"

#define STEM   "12_textures"
#define SHADER "chapters/12_textures.frag"

static const double roughness = 0.12, cells = 2.8, gain = 0.45, far_away = 60.0;
static const struct d3 low = {-1.85, -0.1, -0.62}, high = {2.25, 1.6, 0.62};
static const struct d3 row_low = {-0.7, -0.1, -9.3}, row_high = {2.7, 2.25, -2.3};
static const struct d3 sun = {-0.899, 0.345, 0.269};

// ---- The scene, told once more ----

static double round_box(struct d3 p, struct d3 half, double radius)
{
    return mirror_box(p, d3_sub(half, d3(radius, radius, radius))) - radius;
}

static double smooth_stones(struct d3 p)
{
    double under = round_box(d3(fabs(p.x - 0.2) - 1.2, p.y - 0.36, p.z), d3(0.45, 0.53, 0.5), 0.16);
    struct d3 q = d3_sub(p, d3(1.9, 0.9, -3.2));
    double along = 0.33 * q.x + 0.944 * q.z, nearest = round(along / 2.7);
    nearest = fmin(fmax(nearest, -2.0), 0.0);
    return fmin(under, round_box(d3(0.944 * q.x - 0.33 * q.z, q.y, along - 2.7 * nearest),
                                 d3(0.5, 1.25, 0.62), 0.3));
}

static double rough_stones(struct d3 p)
{
    return smooth_stones(p) + roughness * noise_value(d3_times(cells, p)).value;
}

static double stretch(void)
{
    return 1.0 + roughness * cells * 15.0 / 8.0;
}

static double wave(double x)
{
    double s = 2.0 * (x - floor(x)) - 1.0;
    return s * (1.0 - fabs(s));
}

static double cloth(struct d3 p)
{
    struct d3 q = d3_sub(p, d3(0.75, 0.6, 0.0));
    double hang = fmin(fmax(0.475 - 1.25 * q.y, 0.0), 1.0);
    double aside =
        fabs(fabs(q.z) - (0.12 * wave(1.8 * q.x) + 0.03 * wave(4.1 * q.x)) * hang) - 0.43;
    double up = q.y - 0.33;
    double box = hypot(fmax(aside, 0.0), fmax(up, 0.0)) + fmin(fmax(aside, up), 0.0);
    double hem = fmax(-0.34 - q.y, fabs(q.x + 0.1 * (q.y - 0.4)) - 0.48);
    return fmax(fabs(box - 0.05) - 0.012, hem) / sqrt(1.0 + 0.7 * 0.7);
}

static double scene_distance(struct d3 p, int *nearest)
{
    double board = round_box(d3_sub(p, d3(0.2, 0.9, 0.0)), d3(1.95, 0.06, 0.46), 0.02);
    double ball = mirror_sphere(d3_sub(p, d3(-1.1, 1.24, 0.0)), 0.28); // at time 0
    double stones = fmax(smooth_stones(p), rough_stones(p) / stretch());
    if (nearest != NULL)
        *nearest = 0;
    return fmin(fmin(stones, board), fmin(ball, cloth(p)));
}

static const struct mirror_scene scene = {.function = scene_distance};

// ---- Is it a bound, and with how much to spare? ----

static double random_in(double from, double to)
{
    return from + (to - from) * rand() / RAND_MAX;
}

static struct d3 random_near_stones(void)
{
    double x = random_in(-1.7, 2.1), y = random_in(0.0, 1.0);
    return d3(x, y, random_in(-0.6, 0.6));
}

static struct d3 random_direction(void)
{
    struct d3 v;
    do {
        double x = random_in(-1.0, 1.0), y = random_in(-1.0, 1.0);
        v = d3(x, y, random_in(-1.0, 1.0));
    } while (d3_length(v) > 1.0 || d3_length(v) < 0.01);
    return d3_unit(v);
}

static void test_the_distance_is_1_lipschitz(void **unused)
{
    (void)unused;
    enum { PAIRS = 300000 };
    double all = 0.0, stones = 0.0, clothes = 0.0;
    srand(4);
    for (int i = 0; i < PAIRS; i++) {
        struct d3 p = random_near_stones(), q = d3_add(p, d3_times(1e-3, random_direction()));
        all = fmax(all, fabs(scene_distance(p, NULL) - scene_distance(q, NULL)) / 1e-3);
        stones = fmax(stones, fabs(rough_stones(p) - rough_stones(q)) / 1e-3);
        clothes = fmax(clothes, fabs(cloth(p) - cloth(q)) / 1e-3);
    }
    print_message(
        "# %d pairs: the scene changes by at most %.4f of the way, the cloth by %.4f; the rough "
        "stones before they are divided by %.4f, and they are divided by %.4f: %.0f %% to spare\n",
        PAIRS, all, clothes, stones, stretch(), 100.0 * (stretch() / stones - 1.0));
    assert_true(all <= 1.0 + 1e-9 && clothes <= 1.0 + 1e-9);
    assert_true(stones <= stretch() && stones > 0.75 * stretch());
}

// Where a ray first comes into a rough stone, by small steps that know nothing of slopes.
static double first_inside(struct mirror_ray ray, double end)
{
    const double step = 2e-3;
    for (double t = 0.0; t < end; t += step)
        if (rough_stones(mirror_at(ray, t)) < 0.0)
            return t;
    return end;
}

static double stones_alone(struct d3 p, int *nearest)
{
    if (nearest != NULL)
        *nearest = 0;
    return fmax(smooth_stones(p), rough_stones(p) / stretch());
}

static const struct mirror_scene stones_scene = {.function = stones_alone};

// The march never passes a place that small steps find inside; and it ends there, at most a little
// before.
static void test_no_ray_passes_a_rough_stone(void **unused)
{
    (void)unused;
    int hits = 0, misses = 0;
    double steps = 0.0;
    srand(5);
    for (int i = 0; i < 1500; i++) {
        struct d3 from = d3_add(d3(-1.0, 0.45, 0.0), d3_times(1.6, random_direction()));
        struct d3 to = d3_add(d3(-1.0, 0.45, 0.0), d3_times(0.75, random_direction()));
        struct mirror_ray ray = {from, d3_unit(d3_sub(to, from))};
        double truth = first_inside(ray, 3.0);
        struct mirror_march march = mirror_march(&stones_scene, ray, 0.0, 3.0, 1e-5, 4000);
        assert_true(march.end != MIRROR_GAVE_UP);
        assert_true(truth >= 3.0 || march.t <= truth + 1e-9);
        if (march.end == MIRROR_HIT) {
            assert_true(stones_alone(mirror_at(ray, march.t), NULL) < 1e-5);
            hits += truth < 3.0;
            steps += march.steps;
        } else {
            assert_true(truth >= 3.0);
            misses++;
        }
    }
    print_message("# %d rays hit, %d miss; %.1f steps a hit\n", hits, misses, steps / hits);
    assert_true(hits > 300 && misses > 100);
}

// ---- The normal of the first octave ----

static struct d3 smooth_normal(struct d3 p)
{
    const double h = 1e-5;
    struct d3 x = d3(h, 0.0, 0.0), y = d3(0.0, h, 0.0), z = d3(0.0, 0.0, h);
    return d3_unit(d3(smooth_stones(d3_add(p, x)) - smooth_stones(d3_sub(p, x)),
                      smooth_stones(d3_add(p, y)) - smooth_stones(d3_sub(p, y)),
                      smooth_stones(d3_add(p, z)) - smooth_stones(d3_sub(p, z))));
}

// The carved stone's normal, and the smooth one's tilted by the same noise: degrees between them on
// the front stones, between the ground and the board.
static void test_a_bump_is_nearly_the_carving(void **unused)
{
    (void)unused;
    int seen = 0;
    double sum = 0.0, largest = 0.0;
    srand(6);
    while (seen < 20000) {
        struct d3 p = random_near_stones();
        if (rough_stones(p) <= 0.0)
            continue;
        for (int i = 0; i < 60; i++)
            p = d3_sub(p, d3_times(0.6 * rough_stones(p), smooth_normal(p)));
        if (fabs(rough_stones(p)) > 1e-6 || p.y < 0.0 || p.y > 0.84)
            continue;
        struct d3 n = smooth_normal(p);
        struct d3 slope = d3_times(roughness * cells, noise_value(d3_times(cells, p)).gradient);
        struct d3 carved = d3_unit(d3_add(n, slope));
        struct d3 bumped = d3_unit(d3_sub(d3_add(n, slope), d3_times(d3_dot(slope, n), n)));
        double angle = asin(fmin(d3_length(d3_cross(carved, bumped)), 1.0)) * 180.0 / acos(-1.0);
        sum += angle;
        largest = fmax(largest, angle);
        seen++;
    }
    print_message("# bumped and carved normals: %.2f degrees apart in the mean, at most %.2f\n",
                  sum / seen, largest);
    assert_true(sum / seen < 0.6 && largest < 4.0);
}

// ---- Colours ----

static struct d3 mix(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

static struct d3 sky_light(struct d3 direction)
{
    double high_up = 1.0 - exp(-3.6 * fmax(direction.y, 0.0));
    double facing = fmax(d3_dot(direction, sun), 0.0);
    return d3_add(mix(d3(0.46, 0.53, 0.60), d3(0.07, 0.16, 0.34), high_up),
                  d3_times(facing * facing, d3(0.55, 0.36, 0.18)));
}

// The ground: five octaves, whose gradient tilts the normal.
static struct d3 ground_light(struct d3 p, struct mirror_sample *sample)
{
    const double scale = 1.8, bumps = 0.02, frost = 0.45;
    struct noise noise = noise_octaves(d3_times(cells * scale, p), 5, gain, 2.0);
    struct d3 slope = d3_times(bumps * scale * cells * noise_sum(gain, 5), noise.gradient);
    struct d3 normal = d3_unit(d3(slope.x, 1.0, slope.z));
    double white = frost * mirror_smoothstep(0.3, 0.95, normal.y) *
                   mirror_smoothstep(0.35, 0.6, noise.value + 0.25 * frost);
    struct d3 earth = mix(d3(0.016, 0.014, 0.012), d3(0.10, 0.085, 0.07), noise.value);
    struct d3 colour = mix(earth, d3(0.62, 0.66, 0.72), white);
    struct mirror_ray up = {d3_add(p, d3_times(0.01, normal)), sun};
    double t[2], caught = mirror_lambert(normal, sun);
    sample->faces = caught > 0.0;
    sample->shadowed = sample->faces && brute_box_interval(up, low, high, t) &&
                       mirror_reach(&scene, up, t[0], t[1]).end == MIRROR_HIT;
    struct d3 light = mix(d3(0.028, 0.03, 0.034), d3(0.13, 0.18, 0.26), 0.5 + 0.5 * normal.y);
    if (!sample->shadowed)
        light = d3_add(light, d3_times(caught, d3(2.2, 1.62, 1.05)));
    return d3_product(colour, light);
}

static bool meets(struct mirror_ray ray, struct d3 from, struct d3 to, double end)
{
    double t[2];
    return brute_box_interval(ray, from, to, t) &&
           mirror_reach(&scene, ray, t[0], fmin(t[1], end)).end == MIRROR_HIT;
}

static struct mirror_sample sample_at(const struct mirror_eye *eye)
{
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, 2.0, eye->x, eye->y);
    struct mirror_sample sample = {.what = "sky"};
    double t = ray.direction.y < 0.0 ? fmin(-ray.origin.y / ray.direction.y, far_away) : far_away;
    struct d3 light = sky_light(ray.direction);
    if (meets(ray, low, high, t) || meets(ray, row_low, row_high, t)) {
        sample.what = "thing";
    } else if (t < far_away) {
        struct d3 mist = sky_light(d3(ray.direction.x, 0.02, ray.direction.z));
        sample.what = "ground";
        light = mix(mist, ground_light(mirror_at(ray, t), &sample), exp(-0.006 * t * t));
    }
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

static const struct mirror_picture picture = {
    .name = STEM, .shader = SHADER, .chapter = STEM, .time = 0.0, .sample = sample_at};

static const struct pixel pixels[] = {
    {STEM, 20, 340, "sky-"},     {STEM, 600, 350, "sky-"},    {STEM, 520, 300, "sky-"},
    {STEM, 30, 20, "ground+"},   {STEM, 90, 100, "ground+"},  {STEM, 600, 60, "ground+"},
    {STEM, 500, 30, "ground+"},  {STEM, 40, 240, "ground+"},  {STEM, 330, 110, "ground#"},
    {STEM, 350, 125, "ground#"}, {STEM, 560, 160, "ground#"},
};

// The gradient of the noise changes by up to 40 a unit, and places on the ground by 3e-6 with
// rounding.
static void test_pixels(void **unused)
{
    (void)unused;
    struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.2 / 255.0};
    pixels_check(&picture, &list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_distance_is_1_lipschitz),
        cmocka_unit_test(test_no_ray_passes_a_rough_stone),
        cmocka_unit_test(test_a_bump_is_nearly_the_carving),
        cmocka_unit_test(test_pixels),
    };
    return cmocka_run_group_tests_name("scene_12", tests, gpu_setup, gpu_teardown);
}
