// test_scene_18.c - the islet of chapter 18 in double precision: pixels of its picture, whose sky
// is an integral and no table, and the slope of its distance.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_air.h"
#include "support_pixels.h"

#define CHAPTER "18_sky_from_tables"

enum { HEIGHT = 360 };

static const double threshold = 0.01, pixel_spread = 1.0 / (HEIGHT * MIRROR_FOCAL_LENGTH);
static const struct d3 pine_foot = {29.0, 2.4, -47.0}, hill = {33.0, -28.0, -48.0};

// ---- The scene ----

static double zigzag(double x)
{
    return 4.0 * fabs(x - floor(x) - 0.5) - 1.0;
}

static double ball(struct d3 p, double x, double y, double z, double radius)
{
    return d3_length(d3_sub(p, d3(x, y, z))) - radius;
}

static double pine(struct d3 p)
{
    struct d3 q = d3_sub(p, pine_foot);
    q.x += (0.3 - 0.02 * q.y) * q.y;
    double trunk = fmax(hypot(q.x, q.z) - 0.45 + 0.035 * q.y, fmax(q.y - 6.6, -2.0 - q.y));
    struct d3 c = d3(q.x + 0.4, q.y - 6.7, q.z), wide = d3(c.x, 1.9 * c.y, c.z);
    double domes = fmin(ball(wide, 0.2, 0.4, 0.0, 3.7),
                        fmin(ball(wide, -3.3, -0.6, 0.4, 2.2), ball(wide, 3.1, -0.2, -0.3, 2.3)));
    double leaf = 0.13 * zigzag(0.83 * c.x + 0.5 * c.y + 0.6 * c.z);
    return fmin(0.75 * trunk, fmax(0.4 * (domes - leaf), 0.55 * (leaf - 0.5 - c.y)));
}

static double land(struct d3 p)
{
    double nearest = fmin(ball(p, hill.x, hill.y, hill.z, 31.0),
                          fmin(ball(p, 24.0, -4.2, -45.0, 6.0), ball(p, 13.0, -1.9, -47.0, 2.5)));
    return 0.65 * (nearest + 0.3 * zigzag(0.13 * p.x + 0.06 * p.y + 0.05 * p.z) +
                   0.13 * zigzag(0.41 * p.x - 0.2 * p.y + 0.3 * p.z));
}

static double distance_of(struct d3 p, const double bend[2])
{
    double depth = fmax(-p.y, 0.0);
    struct d3 q = d3(p.x + bend[0] * depth, fabs(p.y), p.z + bend[1] * depth);
    return fmin(land(q), pine(q));
}

// ---- Sun and light ----

static struct d3 sun_direction(void)
{
    double hour = 18.4, place = 43.6 * MIRROR_PI / 180.0, season = 2.0 * MIRROR_PI / 180.0;
    double turn = 15.0 * (hour - 12.0) * MIRROR_PI / 180.0;
    return d3(cos(place) * sin(season) - sin(place) * cos(season) * cos(turn),
              sin(place) * sin(season) + cos(place) * cos(season) * cos(turn),
              -cos(season) * sin(turn));
}

static struct d3 sky_light(struct d3 direction, struct d3 sun)
{
    double level = hypot(direction.x, direction.z) * hypot(sun.x, sun.z), light[3];
    double azimuth = (direction.x * sun.x + direction.z * sun.z) / fmax(level, 1e-9);
    air_light_of(sun.y, fmax(direction.y, 0.0), fmax(fmin(azimuth, 1.0), -1.0), 1.0, 120.0, light);
    return d3(fmax(light[0], 0.0), fmax(light[1], 0.0), fmax(light[2], 0.0));
}

// The closed forms of the library, held against the integral by test_sky_table.
static double brightness(double s)
{
    double deep = fmax(-s, 0.0);
    return -0.41 - 0.352 / (fmax(s, 0.0) + 0.1) - 36.0 * deep - 305.0 * deep * deep;
}

static struct d3 ambient(double s)
{
    double more = mirror_smoothstep(0.0, 0.1, -s);
    return d3_times(exp2(brightness(s)), d3(0.92 - 0.19 * more, 1.02, 1.08 + 0.42 * more));
}

static double film_curve(double x)
{
    double gamma = 1.35, white = 6.0, g = pow(0.18, gamma), w = pow(white, gamma);
    double k = 0.82 * g * w / (0.18 * w - g);
    return (1.0 + k / w) / (1.0 + k / pow(fmin(fmax(x, 1e-6), white), gamma));
}

static struct d3 developed(struct d3 light, double s)
{
    double stops = -2.3 - 0.85 * log2(exp2(brightness(s)) + 6e-8);
    struct d3 e = d3_times(exp2(stops), d3(light.x / 1.156, light.y / 0.976, light.z / 0.796));
    double most = fmax(fmax(e.x, fmax(e.y, e.z)), 1e-6), shown = film_curve(most);
    double bleach = e.y / (e.y + 8.0);
    double film[3] = {e.x, e.y, e.z};
    for (int c = 0; c < 3; c++)
        film[c] = mirror_encode((1.0 - bleach) * film[c] * shown / most + bleach * shown);
    return d3(film[0], film[1], film[2]);
}

// ---- A pixel ----

static void wave_slope(double x, double z, double width, double slope[2])
{
    const double way[2][2] = {{0.08, 0.22}, {-0.41, 0.77}}, fade[2] = {2.0, 30.0};
    slope[0] = slope[1] = 0.0;
    for (int i = 0; i < 2; i++) {
        double phase = way[i][0] * x + way[i][1] * z, u = fabs(phase - floor(phase) - 0.5);
        double size =
            0.04 * (1.0 - 8.0 * u * u * (3.0 - 4.0 * u)) / (1.0 + width * width * fade[i]);
        for (int k = 0; k < 2; k++)
            slope[k] += size * way[i][k] / hypot(way[i][0], way[i][1]);
    }
}

static struct mirror_sample sample_18(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.what = "sky"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct d3 d = ray.direction, sun = sun_direction(), leaves = d;
    bool sea = d.y < 0.0;
    double down = fmax(-d.y, 1e-4), to_sea = sea ? ray.origin.y / down : 1e5, bend[2] = {0.0, 0.0};
    if (sea) {
        wave_slope(ray.origin.x + to_sea * d.x, ray.origin.z + to_sea * d.z,
                   2.0 * pixel_spread * to_sea / down, bend);
        bend[0] *= 2.0;
        bend[1] *= 2.0;
        leaves = d3_unit(d3(d.x + bend[0] * down, down + 0.02, d.z + bend[1] * down));
    }
    // A march of its own: short steps in place of the boxes.
    bool found = false;
    double t = 20.0;
    for (int step = 0; step < 4000 && t < 90.0 && !found; step++) {
        double h = distance_of(mirror_at(ray, t), bend);
        found = h < threshold + pixel_spread * t;
        t += found ? 0.0 : fmax(h, 0.005);
    }
    struct d3 p = mirror_at(ray, t), light = found ? d3(0.0, 0.0, 0.0) : sky_light(leaves, sun);
    p.y = fabs(p.y);
    bool mirrored = sea && (!found || t > to_sea), leaf = p.y > pine_foot.y + 5.2;
    if (found) {
        struct d3 way = d3_sub(p, leaf ? d3_add(pine_foot, d3(-1.4, 6.0, 0.0)) : hill);
        struct d3 normal = d3_unit(leaf ? d3(way.x, 3.0 * way.y, way.z) : way);
        struct d3 colour = leaf ? d3(0.04, 0.06, 0.03) : d3(0.11, 0.1, 0.075);
        light = d3_times(0.6 + 0.4 * normal.y, d3_product(colour, ambient(sun.y)));
        sample.what = leaf ? "pine" : "islet";
    }
    if (mirrored) {
        double grazing = 1.0 - fmin(down + 0.04, 1.0), share = 0.02 + 0.98 * pow(grazing, 5.0);
        struct d3 water = d3_product(d3(0.01, 0.03, 0.04), ambient(sun.y));
        light = d3_add(d3_times(1.0 - share, water), d3_times(share, light));
        sample.what = found ? "image" : "water";
    }
    sample.colour = developed(light, sun.y);
    return sample;
}

// ---- Tests ----

static const struct pixel pixels[] = {
    {CHAPTER, 100, 340, "sky-"},   {CHAPTER, 320, 330, "sky-"},   {CHAPTER, 560, 300, "sky-"},
    {CHAPTER, 200, 230, "sky-"},   {CHAPTER, 600, 200, "sky-"},   {CHAPTER, 60, 160, "sky-"},
    {CHAPTER, 60, 20, "water-"},   {CHAPTER, 200, 60, "water-"},  {CHAPTER, 600, 15, "water-"},
    {CHAPTER, 440, 117, "islet-"}, {CHAPTER, 500, 108, "islet-"}, {CHAPTER, 425, 172, "pine-"},
    {CHAPTER, 425, 32, "image-"},
};

// The film is steep, so that the table's step of 255 may be two.
static void test_pixels_agree_with_the_integral(void **unused)
{
    (void)unused;
    const struct mirror_picture picture = {.name = CHAPTER,
                                           .shader = "chapters/18_sky_from_tables.frag",
                                           .chapter = CHAPTER,
                                           .sample = sample_18};
    const struct pixel_list list = {pixels, sizeof pixels / sizeof *pixels, 3.0 / 255.0};
    pixels_check(&picture, &list);
}

// No chord of the distance is steeper than 1, above the water; below it the image is drawn aside,
// by a bend of at most 2 x 0.08, and for the march's sake the sum of both must stay below 1 too.
static void test_distance_is_a_lower_bound(void **unused)
{
    (void)unused;
    double steepest = 0.0;
    uint32_t bits = 1;
    for (int i = 0; i < 400000; i++) {
        double r[8];
        for (int k = 0; k < 8; k++) {
            bits = bits * 1664525U + 1013904223U;
            r[k] = bits / 4294967296.0;
        }
        double bend[2] = {0.16 * (2.0 * r[6] - 1.0), 0.16 * (2.0 * r[7] - 1.0)};
        struct d3 a = d3(8.0 + 42.0 * r[0], -14.0 + 28.0 * r[1], -64.0 + 32.0 * r[2]);
        struct d3 step =
            d3_times(0.02 + 0.5 * (i % 2), d3_sub(d3(r[3], r[4], r[5]), d3(0.5, 0.5, 0.5)));
        double chord = fabs(distance_of(d3_add(a, step), bend) - distance_of(a, bend));
        steepest = fmax(steepest, chord / d3_length(step));
    }
    print_message("# steepest chord %.3f\n", steepest);
    assert_true(steepest <= 1.0 && steepest > 0.7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_the_integral),
        cmocka_unit_test(test_distance_is_a_lower_bound),
    };
    return cmocka_run_group_tests_name("scene of chapter 18", tests, gpu_setup, gpu_teardown);
}
