// test_scene_07.c - chapter 07's field of lanterns in double precision: pixels of its picture, and
// the table of the probe, whose every step is held against all lanterns near.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_cell.h"
#include "support_pixels.h"

enum { WIDTH = 640, HEIGHT = 360 };

static const double period = 5.5, far = 38.0, low = 0.15, high = 2.95, fog = 26.0;
static const struct d3 zenith = {0.012, 0.020, 0.075}, haze = {0.06, 0.042, 0.09},
                       glow = {0.95, 0.36, 0.12}, sunset = {-0.384, 0.030, -0.923};

static struct probe probe; // too large for the stack

// ---- The lanterns ----

struct lantern {
    struct d3 middle;
    double size, hue;
};

static double digits(double x)
{
    return x - floor(x);
}

static struct lantern lantern_of(int x, int z)
{
    double random = cell_hash(x, 0, z);
    return (struct lantern){d3(period * x, 1.55 + random - 0.5, period * z),
                            1.15 - 0.4 * digits(64.0 * random),
                            25.0 + 300.0 * digits(4096.0 * random)};
}

static struct lantern lantern_near(struct d3 p)
{
    return lantern_of((int)floor(p.x / period + 0.5), (int)floor(p.z / period + 0.5));
}

static double ball(const struct lantern *lantern, struct d3 p)
{
    return d3_length(d3_sub(p, lantern->middle)) - 0.34 * lantern->size;
}

// From the nearest point of the twelve edges to p, edge by edge.
static struct d3 from_edges(const struct lantern *lantern, struct d3 p)
{
    struct d3 q = d3_sub(p, lantern->middle), best = {1e9, 0.0, 0.0};
    const double x = 0.5 * lantern->size, y = 0.7 * lantern->size;
    for (int i = 0; i < 12; i++) {
        double a = i % 2 == 0 ? 1.0 : -1.0, b = i / 2 % 2 == 0 ? 1.0 : -1.0;
        struct d3 edge = d3(a * x, b * y, fmin(fmax(q.z, -x), x));
        if (i / 4 == 1)
            edge = d3(fmin(fmax(q.x, -x), x), a * y, b * x);
        if (i / 4 == 2)
            edge = d3(a * x, fmin(fmax(q.y, -y), y), b * x);
        struct d3 away = d3_sub(q, edge);
        best = d3_length(away) < d3_length(best) ? away : best;
    }
    return best;
}

static double frame(const struct lantern *lantern, struct d3 p)
{
    return d3_length(from_edges(lantern, p)) - 0.05;
}

static double own_distance(struct d3 p)
{
    struct lantern lantern = lantern_near(p);
    return fmin(ball(&lantern, p), frame(&lantern, p));
}

// The chapter's distance: the own lantern, and the way to where others may begin.
static double capped_distance(struct d3 p)
{
    struct lantern lantern = lantern_near(p);
    double aside = fmax(fabs(p.x - lantern.middle.x), fabs(p.z - lantern.middle.z));
    return fmin(own_distance(p), period - aside - (1.15 * 0.5 + 0.05));
}

// The truth: the nearest of 49 lanterns.
static double brute_distance(struct d3 p)
{
    int x = (int)floor(p.x / period + 0.5), z = (int)floor(p.z / period + 0.5);
    double nearest = 1e9;
    for (int i = 0; i < 49; i++) {
        struct lantern lantern = lantern_of(x + i % 7 - 3, z + i / 7 - 3);
        nearest = fmin(nearest, fmin(ball(&lantern, p), frame(&lantern, p)));
    }
    return nearest;
}

// ---- The march ----

struct found {
    bool hit;
    double t;
    int steps;
};

// The part of a ray in the slab of air that holds the lanterns.
static void slab_interval(struct mirror_ray ray, double t[2])
{
    double a = (low - ray.origin.y) / ray.direction.y, b = (high - ray.origin.y) / ray.direction.y;
    t[0] = fmax(fmin(a, b), 0.0);
    t[1] = fmin(fmax(a, b), far);
}

static double threshold_at(double t)
{
    return 0.001 + 2.0 * t / (HEIGHT * MIRROR_FOCAL_LENGTH);
}

static struct found field_march(struct mirror_ray ray)
{
    double interval[2];
    slab_interval(ray, interval);
    struct found found = {false, interval[0], 0};
    while (found.t < interval[1] && found.steps < 128) {
        double distance = capped_distance(mirror_at(ray, found.t));
        found.steps++;
        if (distance < threshold_at(found.t)) {
            found.hit = true;
            break;
        }
        found.t += distance;
    }
    return found;
}

// ---- The colour ----

static struct d3 pure_hue(double hue, double saturation)
{
    double channel[3];
    for (int i = 0; i < 3; i++) {
        double place = fmod(hue / 60.0 + (i == 0 ? 0.0 : 6.0 - 2.0 * i), 6.0);
        channel[i] = 1.0 - saturation + saturation * mirror_clamp(fabs(place - 3.0) - 1.0);
    }
    return d3(channel[0], channel[1], channel[2]);
}

static struct d3 blend(struct d3 a, struct d3 b, double k)
{
    return d3_add(d3_times(1.0 - k, a), d3_times(k, b));
}

static struct d3 sky(struct d3 direction)
{
    double dark = exp(-6.0 * fmax(direction.y, 0.0)),
           towards = fmax(d3_dot(direction, sunset), 0.0);
    double shine = dark * dark * (0.05 + 0.1 * towards + 0.55 * pow(towards, 8.0));
    return d3_add(blend(zenith, haze, dark), d3_times(shine, glow));
}

static struct d3 received(const struct lantern *lantern, struct d3 p, struct d3 normal)
{
    struct d3 to = d3_sub(lantern->middle, p);
    double away = d3_length(to);
    double share = mirror_lambert(normal, d3_times(1.0 / away, to)) *
                   mirror_fall_off(away, 2.0 * lantern->size) *
                   (1.0 - mirror_smoothstep(0.2, 0.5, fabs(to.x) / period)) *
                   (1.0 - mirror_smoothstep(0.2, 0.5, fabs(to.z) / period));
    struct d3 above = d3_add(zenith, d3_times(0.5, haze));
    struct d3 dusk = blend(d3_times(0.3, haze), above, 0.5 + 0.5 * normal.y);
    dusk = d3_add(dusk, d3_times(0.25 * mirror_lambert(normal, sunset), glow));
    return d3_add(dusk, d3_times(share, pure_hue(lantern->hue, 0.75)));
}

static struct d3 surface(struct mirror_ray ray, struct d3 p, bool hit, struct mirror_sample *sample)
{
    struct lantern lantern = lantern_near(p);
    bool glows = hit && ball(&lantern, p) < frame(&lantern, p);
    struct d3 outward = glows ? d3_sub(p, lantern.middle) : from_edges(&lantern, p);
    struct d3 normal = hit ? d3_unit(outward) : d3(0.0, 1.0, 0.0);
    sample->what = glows ? "ball" : (hit ? "frame" : "ground");
    sample->faces = d3_dot(normal, d3_sub(lantern.middle, p)) > 0.0;
    if (glows) {
        double facing = fabs(d3_dot(normal, ray.direction));
        double saturation = 0.9 - 0.5 * facing * facing;
        return d3_times(0.8 + 1.1 * facing, pure_hue(lantern.hue, saturation));
    }
    struct d3 matt = hit ? d3(0.50, 0.44, 0.42) : d3(0.13, 0.14, 0.19);
    return d3_product(matt, received(&lantern, p, normal));
}

static struct mirror_sample sample_07(const struct mirror_eye *eye)
{
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    ray.origin.z -= 0.5 * eye->time;
    struct found found = field_march(ray);
    double ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : far;
    double t = found.hit ? found.t : fmin(ground, far);
    struct mirror_sample sample = {.what = "sky"};
    struct d3 light = sky(ray.direction);
    double clear = exp(-t / fog) * mirror_clamp((far - t) / 12.0);
    if (t < far)
        light = blend(light, surface(ray, mirror_at(ray, t), found.hit, &sample), clear);
    sample.colour = d3(mirror_encode(mirror_clamp(light.x)), mirror_encode(mirror_clamp(light.y)),
                       mirror_encode(mirror_clamp(light.z)));
    return sample;
}

static const struct mirror_picture picture = {"07_repetition", "chapters/07_repetition.frag",
                                              "07_repetition", 0.0, sample_07};
static const struct mirror_picture later = {"07_repetition later", "chapters/07_repetition.frag",
                                            "07_repetition", 8.8, sample_07};

static const struct pixel pixels[] = {
    {"07_repetition", 100, 330, "sky-"},         {"07_repetition", 560, 350, "sky-"},
    {"07_repetition", 96, 30, "frame+"},         {"07_repetition", 108, 54, "frame+"},
    {"07_repetition", 174, 114, "frame+"},       {"07_repetition", 84, 42, "frame-"},
    {"07_repetition", 162, 102, "frame-"},       {"07_repetition", 468, 102, "frame-"},
    {"07_repetition", 114, 90, "ball-"},         {"07_repetition", 480, 126, "ball-"},
    {"07_repetition", 186, 186, "ball-"},        {"07_repetition", 324, 216, "ball-"},
    {"07_repetition", 240, 42, "ground+"},       {"07_repetition", 480, 72, "ground+"},
    {"07_repetition", 360, 144, "ground+"},      {"07_repetition", 300, 180, "ground+"},
    {"07_repetition later", 156, 126, "ball-"},  {"07_repetition later", 426, 156, "ball-"},
    {"07_repetition later", 186, 204, "ball-"},  {"07_repetition later", 480, 36, "ground+"},
    {"07_repetition later", 360, 96, "ground+"}, {"07_repetition later", 240, 120, "ground+"},
    {"07_repetition later", 100, 340, "sky-"},
};

static void test_pixels(void **unused)
{
    (void)unused;
    const struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.25 / 255.0};
    pixels_check(&picture, &list);
    pixels_check(&later, &list);
}

// ---- The probe ----

// What the rows of all tables say.
struct rows {
    int rays, hits, rows;
    double over; // the largest distance over the truth
    int longest; // steps of a ray
};

static void check_row(const struct probe_step *row, bool capped, struct rows *rows)
{
    struct d3 p = d3_of(row->position);
    double expected = capped ? capped_distance(p) : own_distance(p);
    assert_true(fabs((double)row->distance - expected) < 1e-5);
    rows->over = fmax(rows->over, (double)row->distance - brute_distance(p));
    rows->rows++;
}

static void check_table(struct mirror_ray ray, bool capped, struct rows *rows)
{
    double interval[2];
    slab_interval(ray, interval);
    for (int i = 0; i < probe.steps; i++) {
        const struct probe_step *row = &probe.step[i];
        double t = i == 0 ? interval[0] : (double)(row[-1].t + row[-1].distance);
        assert_true(fabs((double)row->t - t) < 4e-5);
        assert_true(d3_length(d3_sub(mirror_at(ray, (double)row->t), d3_of(row->position))) < 4e-5);
        assert_true((double)row->distance >= threshold_at((double)row->t) - 1e-6 ||
                    i == probe.steps - 1);
        check_row(row, capped, rows);
    }
    rows->rays++;
    rows->hits += probe.end == PROBE_HIT;
    rows->longest = probe.steps > rows->longest ? probe.steps : rows->longest;
}

static void check_rays(bool capped, struct rows *rows)
{
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    assert_true(mirror_camera(gpu.root, "07_repetition", &inputs.camera));
    assert_true(gpu_load("chapters/07_repetition.frag"));
    struct parameter *parameter = parameters_find(&gpu.renderer.parameters, "capped");
    assert_non_null(parameter);
    parameter->value[0] = capped ? 1.0 : 0.0;
    for (int y = 5; y < HEIGHT; y += 20)
        for (int x = 7; x < WIDTH; x += 25) {
            struct mirror_ray ray = mirror_screen_ray(&inputs.camera, MIRROR_FOCAL_LENGTH,
                                                      mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                                                      mirror_screen_y(y + 0.5, HEIGHT));
            assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
            assert_int_equal(probe.evaluations, probe.all_steps);
            check_table(ray, capped, rows);
            struct found found = field_march(ray);
            bool hit = probe.end == PROBE_HIT;
            if (capped && (found.hit == hit || hit))
                assert_true(abs(found.steps - probe.steps) <= 1);
        }
}

static void test_no_step_is_longer_than_the_way_to_any_lantern(void **unused)
{
    (void)unused;
    struct rows capped = {0}, own = {0};
    check_rays(true, &capped);
    check_rays(false, &own);
    print_message("# %d rays, %d hits, %d steps: the longest march %d; over the truth by at most "
                  "%.1e, without the cap by %.2f\n",
                  capped.rays, capped.hits, capped.rows, capped.longest, capped.over, own.over);
    assert_true(capped.over < 1e-5 && own.over > 0.2);
    assert_true(capped.hits > 30 && capped.hits < capped.rays / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels),
        cmocka_unit_test(test_no_step_is_longer_than_the_way_to_any_lantern),
    };
    return cmocka_run_group_tests_name("scene_07", tests, gpu_setup, gpu_teardown);
}
