// test_scene_19.c - the lake of chapter 19 in double precision: pixels of its dusk, between the
// stars, of the ranges, the hill, the dome, and of all of them in the water.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "support_noise.h"
#include "support_pixels.h"
#include "support_stars.h"

#define CHAPTER "19_moon_and_stars"

static const double latitude = 43.6 * MIRROR_PI / 180.0, declination = 2.0, hour = 19.35, age = 2.9;
static const double pixel_spread = 1.0 / (360.0 * MIRROR_FOCAL_LENGTH);
static const double rayleigh[3] = {0.04, 0.1, 0.25};

// Three channels as an array: what the air does, it does to each.
struct light {
    double c[3];
};

static struct d3 d3_from(struct light v)
{
    return d3(v.c[0], v.c[1], v.c[2]);
}

// ---- Sun and moon, by declination and hour angle ----

static struct d3 direction_at(double high, double angle)
{
    return d3(cos(latitude) * sin(high) - sin(latitude) * cos(high) * cos(angle),
              sin(latitude) * sin(high) + cos(latitude) * cos(high) * cos(angle),
              -cos(high) * sin(angle));
}

static struct d3 sun_now(void)
{
    return direction_at(declination * MIRROR_PI / 180.0, (hour - 12.0) * MIRROR_PI / 12.0);
}

static struct d3 moon_now(void)
{
    double e = 23.4393 * MIRROR_PI / 180.0,
           sun = asin(sin(declination * MIRROR_PI / 180.0) / sin(e));
    double l = sun + 2.0 * MIRROR_PI * age / 29.530589;
    double right = atan2(cos(e) * sin(l), cos(l)), sun_right = atan2(cos(e) * sin(sun), cos(sun));
    return direction_at(asin(sin(e) * sin(l)),
                        (hour - 12.0) * MIRROR_PI / 12.0 + sun_right - right);
}

static double zenith(double height)
{
    double d = fmin(-asin(height) * 180.0 / MIRROR_PI - 5.0, 13.3158); // the sun is down
    return 27.0 * pow(10.0, -0.4 * (11.84 + d * (1.518 - 0.057 * d)));
}

// By the phase: of the whole moon, above the air; the integral over the disc in closed form.
static struct light moonlight_now(void)
{
    double g = acos(-d3_dot(moon_now(), sun_now())), h = 0.5 * g;
    double ball = 1.0 - sin(h) * tan(h) * log(1.0 / tan(0.5 * h));
    double light = 2.5e-5 * exp(-0.94 * g) * ball * mirror_smoothstep(-0.1, 0.1, moon_now().y);
    return (struct light){{1.06 * light, light, 0.88 * light}};
}

// ---- The sky ----

static double air_mass(double height)
{
    double climb = 721.5 * fmax(height, 0.0);
    return sqrt(climb * climb + 1444.0) - climb;
}

static double glow(struct d3 direction, struct d3 lamp, double g)
{
    return pow((1.0 - g) * (1.0 - g) / (1.0 + g * g - 2.0 * g * d3_dot(direction, lamp)), 1.5);
}

static struct light sky_light(struct d3 direction)
{
    static const double gain[3] = {1.4, 1.75, 3.1}, blue[3] = {0.016, 0.043, 0.115};
    static const double red[3] = {1.0, 0.62, 0.36};
    struct d3 sun = sun_now(), raised = d3_unit(d3(sun.x, 0.02, sun.z));
    double gone = fmin((zenith(sun.y) - 4.4e-8) / 0.053, 1.0);
    double below = mirror_smoothstep(0.0, -0.1, sun.y);
    double level = hypot(direction.x, direction.z), west = hypot(sun.x, sun.z);
    double toward = 0.5 + 0.5 * (direction.x * sun.x + direction.z * sun.z) / (level * west);
    double view = air_mass(direction.y), mass = air_mass(raised.y), c = d3_dot(direction, raised);
    double day = mirror_smoothstep(-0.25, 0.06, raised.y), apart = view - mass;
    apart = fabs(apart) < 0.02 ? 0.02 : apart;
    struct light light;
    for (int k = 0; k < 3; k++) {
        double depth = rayleigh[k] + 0.03;
        double once = view / apart * (exp(-depth * mass) - exp(-depth * (mass + apart)));
        double lit = gain[k] * day * day * (0.6 + 0.4 * c * c) * once +
                     day * exp(-depth * mass) * glow(direction, raised, 0.8);
        lit *= 1.0 + below * (0.25 + 0.75 * toward - 1.0);
        double low = exp(-direction.y / (0.30 + below * (0.075 - 0.30)));
        double arch = toward * toward * low * exp(-(rayleigh[k] + 0.02) * 0.45 * view);
        double dusk =
            blue[k] * (1.0 + 3.0 * toward * exp(-3.5 * direction.y)) + 6.0 * arch * red[k];
        light.c[k] = (lit + below * (dusk - lit)) * gone;
    }
    return light;
}

static struct light air_light(struct d3 direction)
{
    static const double tint[3] = {0.72, 1.0, 1.25};
    double s = fmax(direction.y, 0.0), layer = 4.5e-8 / sqrt(1.0 - (1.0 - s * s) / 1.0302);
    struct light light = sky_light(direction), moon = moonlight_now();
    for (int k = 0; k < 3; k++) {
        double clear = exp(-rayleigh[k] * air_mass(direction.y));
        double scattered = 0.10 * (1.0 - clear) + 0.25 * glow(direction, moon_now(), 0.9);
        light.c[k] += layer * tint[k] + moon.c[k] * scattered;
    }
    return light;
}

// The direction among the stars.
static struct d3 star_direction(struct d3 d)
{
    double angle = 2.0 * MIRROR_PI * (hour - 12.0) / 23.9344696;
    double meridian = d.y * cos(latitude) - d.x * sin(latitude), west = -d.z;
    return d3(cos(angle) * meridian + sin(angle) * west, sin(angle) * meridian - cos(angle) * west,
              d.x * cos(latitude) + d.y * sin(latitude));
}

static struct light milky_way(struct d3 d)
{
    static const double tint[3] = {2.6e-7, 2.4e-7, 2.5e-7};
    double height = d3_dot(d, d3(-0.86767, -0.19808, 0.45598));
    double ahead = 0.5 + 0.5 * d3_dot(d, d3(-0.05488, -0.87344, -0.48384));
    double n = noise_octaves(d3_times(7.0, d), 3, 0.6, 2.3).value;
    double wide = height + 0.10 * (n - 0.5), dust = height + 0.02 + 0.16 * (n - 0.5);
    double band = exp(-wide * wide / (0.012 + ahead * 0.018)) * (0.25 + 1.5 * n * n);
    double dark = 1.0 - 0.75 * exp(-dust * dust / 0.0012) * mirror_smoothstep(0.35, 0.6, n);
    struct light light;
    for (int k = 0; k < 3; k++)
        light.c[k] = (0.35 + 0.65 * ahead * ahead) * band * dark * tint[k];
    return light;
}

static double coverage(double inside, double width)
{
    return mirror_clamp(inside / (width + 0.001) + 0.5);
}

// Behind the shore: what is seen, and its light. Near a star, and near the moon, it is 'star'.
static struct light sky_all(struct d3 direction, double width, const char **what)
{
    struct d3 above = d3(direction.x, fmax(direction.y, 0.0), direction.z);
    struct d3 star = star_direction(above);
    struct light light = air_light(above), beyond = milky_way(star), air = light;
    double turn = atan2(direction.x, -direction.z),
           up = direction.y / hypot(direction.x, direction.z);
    double far = 0.072 + 0.019 * (sin(5.0 * turn + 0.6) + 0.5 * sin(13.0 * turn));
    double near = 0.042 + 0.013 * (sin(7.0 * turn + 2.9) + 0.5 * sin(19.0 * turn + 1.0));
    double share[2] = {coverage(far - up, 2.0 * width), coverage(near - up, 2.0 * width)};
    bool moon = d3_length(d3_sub(above, moon_now())) < 0.06;
    *what = moon || stars_light(star, 0.0031) > 0.0 ? "star" : "sky";
    *what = share[1] >= 1.0                      ? "near range"
            : share[0] >= 1.0 && share[1] <= 0.0 ? "far range"
                                                 : *what;
    if ((share[0] > 0.0 && share[0] < 1.0) || (share[1] > 0.0 && share[1] < 1.0))
        *what = "edge";
    for (int k = 0; k < 3; k++) {
        light.c[k] += exp(-rayleigh[k] * air_mass(above.y)) * beyond.c[k];
        light.c[k] += share[0] * (0.45 * air.c[k] - light.c[k]);
        light.c[k] += share[1] * (0.22 * air.c[k] - light.c[k]);
    }
    return light;
}

// ---- The shore: its land alone; where wood and dome may be, nothing is asked ----

static double land_along(struct mirror_ray ray)
{
    static const double balls[3][4] = {
        {24.0, -83.7, -62.0, 90.0}, {-38.0, -150.4, -66.0, 152.0}, {-6.0, -498.1, -101.0, 500.0}};
    double nearest = 1e6;
    for (int i = 0; i < 3; i++) {
        double t[2];
        struct mirror_ray from = {d3_sub(ray.origin, d3(balls[i][0], balls[i][1], balls[i][2])),
                                  ray.direction};
        if (mirror_ball_crossing(from, balls[i][3], t) && t[0] > 0.0)
            nearest = fmin(nearest, t[0]);
    }
    return nearest;
}

static bool in_boxes(struct mirror_ray ray, double far)
{
    double t[2];
    return (brute_box_interval(ray, d3(-51.0, -0.2, -60.2), d3(1.4, 8.8, -55.6), t) &&
            t[0] < far) ||
           (brute_box_interval(ray, d3(13.9, 4.1, -60.1), d3(24.0, 12.0, -53.9), t) && t[0] < far);
}

static struct mirror_ray mirrored(struct mirror_ray ray, double t)
{
    struct d3 p = mirror_at(ray, t), d = ray.direction;
    double calm = 0.003 / (1.0 + 0.02 * t), fine = 0.006 * exp(-0.02 * t);
    double a = cos(1.1 * p.x + 4.6 * p.z), b = cos(2.6 * p.x - 3.1 * p.z);
    double e = cos(3.0 * p.x + 17.0 * p.z), f = cos(29.0 * p.z - 6.5 * p.x);
    struct d3 n = d3_unit(
        d3(0.3 * calm * (a - b) + 0.5 * fine * (e - f), 1.0, calm * (a + b) + fine * (e + f)));
    struct d3 away = d3_sub(d, d3_times(2.0 * d3_dot(d, n), n));
    return (struct mirror_ray){p, d3_unit(d3(away.x, fabs(away.y) + 1e-4, away.z))};
}

// ---- The picture ----

static double film(double x)
{
    double g = pow(0.18, 1.4), w = pow(60.0, 1.4), k = 0.82 * g * w / (0.18 * w - g);
    double h = pow(fmin(fmax(x, 1e-6), 60.0), 1.4);
    return (1.0 + k / w) / (1.0 + k / h);
}

static struct d3 shown(struct light light)
{
    double brightest = zenith(sun_now().y) + 0.1 * moonlight_now().c[1];
    double gain = pow(2.0, -0.58 * log2(brightest) + 2.0);
    double most = gain * fmax(light.c[0], fmax(light.c[1], light.c[2])), out = pow(most, 0.6);
    for (int k = 0; k < 3; k++)
        light.c[k] = mirror_encode(light.c[k] * gain / most * film(out));
    return d3_from(light);
}

static struct mirror_sample sample_19(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.what = "sky"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    double cosine = MIRROR_FOCAL_LENGTH / sqrt(MIRROR_FOCAL_LENGTH * MIRROR_FOCAL_LENGTH +
                                               eye->x * eye->x + eye->y * eye->y);
    double width = 2.0 * pixel_spread * pow(cosine, 1.5);
    double lake = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 1e6;
    bool water = lake < land_along(ray);
    struct mirror_ray seen = water ? mirrored(ray, lake) : ray;
    double land = land_along(seen);
    struct light light = sky_all(seen.direction, width, &sample.what);
    if (land < 1e5) {
        static const double colour[3] = {0.05, 0.06, 0.045}, tint[3] = {0.7, 0.9, 1.3};
        double up = fmax(moon_now().y, 0.0);
        for (int k = 0; k < 3; k++)
            light.c[k] = colour[k] * (zenith(sun_now().y) * tint[k] + up * moonlight_now().c[k]);
        sample.what = "land";
    }
    if (in_boxes(seen, fmin(land, 1e5)))
        sample.what = "wood or dome";
    if (water)
        for (int k = 0; k < 3; k++)
            light.c[k] *= 0.03 + 0.95 * (0.02 + 0.98 * pow(1.0 - seen.direction.y, 5.0));
    sample.faces = water; // '+' in the list: in the water
    sample.colour = shown(light);
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 95, 53, "sky+"},          {CHAPTER, 375, 175, "land-"},
    {CHAPTER, 423, 141, "land+"},       {CHAPTER, 572, 61, "sky+"},
    {CHAPTER, 482, 162, "land-"},       {CHAPTER, 413, 158, "land-"},
    {CHAPTER, 567, 178, "land-"},       {CHAPTER, 68, 351, "sky-"},
    {CHAPTER, 341, 152, "land+"},       {CHAPTER, 171, 322, "sky-"},
    {CHAPTER, 39, 31, "sky+"},          {CHAPTER, 543, 85, "sky+"},
    {CHAPTER, 43, 281, "sky-"},         {CHAPTER, 513, 226, "sky-"},
    {CHAPTER, 493, 140, "land+"},       {CHAPTER, 418, 143, "land+"},
    {CHAPTER, 316, 199, "far range-"},  {CHAPTER, 615, 184, "near range-"},
    {CHAPTER, 631, 185, "near range-"}, {CHAPTER, 330, 201, "far range-"},
    {CHAPTER, 621, 190, "near range-"}, {CHAPTER, 330, 196, "far range-"},
    {CHAPTER, 571, 194, "near range-"}, {CHAPTER, 297, 200, "far range-"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    pixels_check_chapter(CHAPTER, sample_19, pixels, sizeof pixels / sizeof *pixels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
    };
    return cmocka_run_group_tests_name("scene of chapter 19", tests, gpu_setup, gpu_teardown);
}
