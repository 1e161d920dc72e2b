// test_scene_21.c - chapter 21 in double precision: pixels of the cabin and of the sail in the
// evening sun, how much of the sun the land leaves to be seen, how steep and how high the land is,
// the moon behind clouds, and the two ends of a day.
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

#define CHAPTER "21_a_landscape"

enum { WIDTH = 640, HEIGHT = 360 };

static const double threshold = 0.0002, disc = 0.0047, highest = 18.8;
static const double spread = 1.0 / (HEIGHT * MIRROR_FOCAL_LENGTH);

// ---- The valley: x right, y up, z ahead ----

static struct d3 local_of(struct d3 p)
{
    return d3(0.4226 * p.x - 0.9063 * p.z, p.y, -0.9063 * p.x - 0.4226 * p.z);
}

static struct d3 world_of(struct d3 p)
{
    return d3(0.4226 * p.x - 0.9063 * p.z, p.y, -0.9063 * p.x - 0.4226 * p.z);
}

static double bump(double x, double z, double a, double b, double height)
{
    double w = fmax(1.0 - x * x / (a * a) - z * z / (b * b), 0.0);
    return height * w * w;
}

static double hills(double x, double z)
{
    double h = bump(x - 4.0, z - 46.0, 43.0, 25.5, 7.4);
    h = fmax(h, bump(x + 25.0, z - 24.0, 24.0, 24.5, 7.0));
    h = fmax(h, bump(x - 64.0, z - 90.0, 58.0, 42.0, 6.4));
    return fmax(h, bump(x - 19.0, z - 22.0, 13.0, 12.5, 3.6)) - 3.0;
}

static double shore(double x, double z)
{
    double a = x + 1.45, b = 1.2 * (z - 0.5);
    return 0.26 - 0.17 * sqrt(a * a + b * b + 0.04);
}

static double land(double x, double z, int octaves)
{
    double u = 0.08 * x + 31.2, v = 0.08 * z + 9.9, weight = 0.58, sum = 0.0, first = 1.0;
    double base = hills(x, z);
    for (int i = 0; base > 0.4 && i < octaves; i++) {
        double ridge = 1.0 - fabs(2.0 * noise_value(d3(u, 0.0, v)).value - 1.0);
        first = i == 0 ? ridge : first;
        sum += weight * ridge;
        weight *= 0.42;
        double next = 2.1 * (0.8 * u - 0.6 * v) + 17.17;
        v = 2.1 * (0.6 * u + 0.8 * v) + 29.73;
        u = next;
    }
    return fmax(base + 3.6 * fmax(base - 0.4, 0.0) * first * sum, shore(x, z));
}

// ---- What stands there ----

static double block(struct d3 p, double a, double b, double c)
{
    return fmax(fabs(p.x) - a, fmax(fabs(p.y) - b, fabs(p.z) - c));
}

static struct d3 at_cabin(struct d3 p)
{
    struct d3 q = d3_sub(p, d3(-0.50, 0.094, 0.74));
    return d3((0.94 * q.x + 0.34 * q.z) / 1.35, q.y / 1.35, (0.94 * q.z - 0.34 * q.x) / 1.35);
}

// Gable roof, walls under it, a chimney.
static double cabin(struct d3 p)
{
    struct d3 q = at_cabin(p);
    double slope = 0.64 * fabs(q.z) + 0.768 * (q.y - 0.066),
           level = block(d3(q.x, 0.0, q.z), 0.042, 1.0, 0.03);
    double walls = fmax(level, fmax(slope, -0.02 - q.y));
    double roof = fmax(fabs(slope) - 0.003, block(d3(q.x, 0.0, q.z), 0.05, 1.0, 0.042));
    double chimney = block(d3_sub(q, d3(0.02, 0.062, 0.012)), 0.006, 0.018, 0.006);
    return 1.35 * fmin(walls, fmin(roof, chimney));
}

static double boat(struct d3 p)
{
    struct d3 q = d3_sub(p, d3(0.62, 0.0, 1.75));
    double hull = fmax(d3_length(d3(0.35 * q.x, q.y - 0.006, q.z)) - 0.010, q.y - 0.008);
    double mast = block(d3_sub(q, d3(0.0, 0.045, 0.0)), 0.0009, 0.045, 0.0009);
    double sail =
        fmax(fmax(q.x + 0.001, 0.013 - q.y), -0.924 * q.x + 0.383 * (q.y - 0.013) - 0.0275);
    double jib = fmax(fmax(0.002 - q.x, 0.015 - q.y), 0.943 * q.x + 0.333 * (q.y - 0.013) - 0.0215);
    return fmin(fmin(hull, mast), fmax(fmin(sail, jib), fabs(q.z) - 0.0007));
}

static double things(struct d3 world)
{
    struct d3 p = local_of(world);
    return fmin(cabin(p), boat(p));
}

// Normal, colour and name of what a point of the cabin or the boat belongs to.
static const char *thing_at(struct d3 world, struct d3 *normal, struct d3 *colour)
{
    struct d3 p = local_of(world), q = at_cabin(p), n;
    *colour = d3(0.8, 0.78, 0.72);
    if (p.x > 0.0) {
        *normal = world_of(d3_unit(d3(0.5, 0.2, -0.84)));
        return "sail";
    }
    bool roof = 0.64 * fabs(q.z) + 0.768 * (q.y - 0.066) > -0.006;
    bool side = fabs(q.x) > 0.0415;
    n = roof   ? d3(0.0, 0.768, copysign(0.64, q.z))
        : side ? d3(copysign(1.0, q.x), 0.0, 0.0)
               : d3(0.0, 0.0, copysign(1.0, q.z));
    *normal = world_of(d3_unit(d3(0.94 * n.x - 0.34 * n.z, n.y, 0.34 * n.x + 0.94 * n.z)));
    double across = fabs(fabs(q.x) - 0.02), up = fabs(q.y - 0.012), plank = 160.0 * q.y;
    bool window = q.z < -0.029 && across < 0.008 && up < 0.008;
    *colour = d3_times(plank - floor(plank) >= 0.5 ? 1.0 : 0.8, d3(0.17, 0.09, 0.05));
    *colour = q.y > 0.03 && roof ? d3(0.10, 0.055, 0.045) : *colour;
    return window ? "window" : roof ? "roof" : side ? "side" : "wall";
}

// ---- The evening ----

static struct d3 sun_at(double hour)
{
    double h = 15.0 * (hour - 12.0) * MIRROR_PI / 180.0, p = 43.6 * MIRROR_PI / 180.0,
           d = 10.0 * MIRROR_PI / 180.0;
    return d3(cos(p) * sin(d) - sin(p) * cos(d) * cos(h),
              sin(p) * sin(d) + cos(p) * cos(d) * cos(h), -cos(d) * sin(h));
}

static double bright_of(double y)
{
    return exp2(-0.41 - 0.352 / (y + 0.1));
}

static struct d3 sunlight(double y)
{
    double climb = 721.5 * y, whole = 2.0 * 721.5 + 1.0,
           m = whole / (sqrt(climb * climb + whole) + climb);
    double in = mirror_smoothstep(-0.012, 0.03, y);
    return d3_times(in, d3(11.5 * exp(-0.1 * m), 10.3 * exp(-0.148 * m), 9.9 * exp(-0.269 * m)));
}

static struct d3 skylight(double y)
{
    double high = y / (y + 0.1);
    struct d3 colour = d3(0.92 - 0.19 * high, 1.02, 1.08 + 0.5 * high);
    return d3_add(d3_times(bright_of(y), colour), d3(6e-8, 6e-8, 6e-8));
}

static double film_of(double x)
{
    double g = pow(0.18, 1.3), w = pow(8.0, 1.3), k = 0.82 * g * w / (0.18 * w - g);
    return (1.0 + k / w) / (1.0 + k / pow(fmin(x, 8.0), 1.3));
}

static struct d3 developed(struct d3 light, double stops)
{
    struct d3 x = d3_times(exp2(stops), d3(light.x / 1.156, light.y / 0.976, light.z / 0.796));
    double largest = fmax(x.x, fmax(x.y, x.z)), share = film_of(largest) / largest;
    return d3(mirror_encode(share * x.x), mirror_encode(share * x.y), mirror_encode(share * x.z));
}

// Haze of one density that thins over 3 units, on a way that is short.
static struct d3 through_haze(struct d3 light, struct mirror_ray ray, double t, struct d3 sun)
{
    double depth = 0.0, c = d3_dot(ray.direction, sun), x = 0.09 / (1.49 - 1.4 * c);
    for (int i = 0; i < 400; i++)
        depth += 0.005 * exp(-mirror_at(ray, t * (i + 0.5) / 400.0).y / 3.0) * t / 400.0;
    struct d3 haze =
        d3_add(d3_times(0.5, skylight(sun.y)), d3_times(0.25 * x * sqrt(x), sunlight(sun.y)));
    return d3_add(d3_times(exp(-depth), light), d3_times(1.0 - exp(-depth), haze));
}

// The smallest of gap / way of a ray from a place, over the land of so many octaves, by small
// steps; to where the ray first meets the land.
static double skyline(struct d3 p, struct d3 direction, int octaves)
{
    double least = 1e9;
    for (double s = 0.02; s < 60.0 && least > 0.0 && p.y + s * direction.y < highest;
         s += fmax(0.002 * s, 0.002)) {
        struct d3 q = local_of(d3_add(p, d3_times(s, direction)));
        least = fmin(least, (q.y - land(q.x, q.z, octaves)) / s);
    }
    return least;
}

static struct mirror_sample sample_21(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.what = "other"};
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    double t = 0.3, h = 1.0;
    while (t < 3.0 && h >= threshold) {
        struct d3 p = mirror_at(ray, t), q = local_of(p);
        h = fmin(things(p), 0.01);
        if (q.y < land(q.x, q.z, 4) || q.y < 0.0)
            return sample;
        t += h;
    }
    if (h >= threshold)
        return sample;
    struct d3 p = mirror_at(ray, t), normal, colour, sun = sun_at(18.4);
    sample.what = thing_at(p, &normal, &colour);
    double facing = mirror_lambert(normal, sun);
    struct d3 from = d3_add(p, d3_times(3.0 * (threshold + spread * t), normal));
    bool hidden = false;
    for (double s = 0.0; facing > 0.0 && s < 3.0 && !hidden; s += 0.0005)
        hidden = things(d3_add(from, d3_times(s, sun))) < 0.0;
    // The whole disc is free, or no light is asked for: the march's steps do not matter.
    assert_true(facing == 0.0 || hidden || skyline(from, sun, 1) > 2.0 * disc);
    struct d3 sky = skylight(sun.y), light = d3_times(0.6 + 0.4 * normal.y, sky);
    light = d3_add(light, d3_times(hidden ? 0.0 : facing, sunlight(sun.y)));
    sample.faces = facing > 0.0;
    sample.shadowed = hidden;
    sample.colour = developed(through_haze(d3_product(colour, light), ray, t, sun),
                              -2.0 - 0.9 * log2(bright_of(sun.y) + 6e-8));
    return sample;
}

static const struct pixel pixels[] = {
    {CHAPTER, 55, 154, "roof+"},  {CHAPTER, 37, 159, "roof+"},  {CHAPTER, 104, 163, "roof+"},
    {CHAPTER, 100, 168, "roof+"}, {CHAPTER, 101, 173, "roof+"}, {CHAPTER, 115, 154, "roof-"},
    {CHAPTER, 115, 157, "roof-"}, {CHAPTER, 114, 160, "roof-"}, {CHAPTER, 94, 180, "roof-"},
    {CHAPTER, 94, 181, "roof-"},  {CHAPTER, 448, 131, "sail+"}, {CHAPTER, 447, 132, "sail+"},
    {CHAPTER, 447, 133, "sail+"}, {CHAPTER, 448, 133, "sail+"}, {CHAPTER, 447, 134, "sail+"},
    {CHAPTER, 107, 129, "side+"}, {CHAPTER, 106, 133, "side+"}, {CHAPTER, 105, 137, "side+"},
    {CHAPTER, 108, 140, "side+"}, {CHAPTER, 107, 145, "side+"}, {CHAPTER, 98, 129, "wall+"},
    {CHAPTER, 71, 133, "wall+"},  {CHAPTER, 69, 137, "wall+"},  {CHAPTER, 70, 141, "wall+"},
    {CHAPTER, 100, 145, "wall+"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    pixels_check_chapter(CHAPTER, sample_21, pixels, sizeof pixels / sizeof *pixels);
}

// ---- Functions of the chapter, asked one by one ----

// What a function of the chapter's writes into the picture: a line of GLSL in place of rayColour.
static float *numbers_of(const char *body)
{
    char text[1200];
    struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, 1);
    snprintf(text, sizeof text,
             "#include \"main.glsl\"\n#define rayColour chapterColour\n"
             "#include \"21_a_landscape.frag\"\n#undef rayColour\n"
             "vec3 rayColour(Ray ray) { vec2 pixel = vec2(iPixel); %s }\n",
             body);
    assert_true(mirror_camera(gpu.root, CHAPTER, &inputs.camera));
    assert_true(gpu_load_text(text));
    float *values = gpu_numbers(&inputs);
    assert_non_null(values);
    return values;
}

// Each over the bound that the march builds on: hills, shore and heights, over all the valley.
static void test_no_land_is_steeper_or_higher_than_is_said(void **unused)
{
    (void)unused;
    float *values = numbers_of("vec2 q = vec2(-60.0, -20.0) + vec2(0.3, 0.45) * pixel;"
                               "vec2 r = vec2(-4.0, -3.0) + 0.0125 * pixel;"
                               "return 0.5 * vec3(length(hills(q).yz) / HILL_SLOPE,"
                               "length(shore(r).yz) / SHORE_SLOPE, landAt(q, 12.0).x / HIGHEST);");
    double most[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < 4 * WIDTH * HEIGHT; i++)
        if (i % 4 < 3)
            most[i % 4] = fmax(most[i % 4], 2.0 * (double)values[i]);
    free(values);
    print_message(
        "# hills reach %.4f of their slope, the shore %.4f, the land %.4f of its height\n", most[0],
        most[1], most[2]);
    assert_true(most[0] <= 1.0 && most[1] <= 1.0 && most[2] <= 1.0);
    assert_true(most[0] > 0.99 && most[1] > 0.98 && most[2] > 0.9);
}

// Is the land out of the way of a point of the disc? r and a from its middle, a from the right.
static bool sees(struct d3 p, struct d3 light, double r, double a)
{
    struct d3 right = d3_unit(d3_cross(light, d3(0.0, 1.0, 0.0))), up = d3_cross(right, light);
    struct d3 aside = d3_add(d3_times(r * cos(a), right), d3_times(r * sin(a), up));
    return skyline(p, d3_unit(d3_add(light, aside)), 1) > 0.0;
}

// The share of the disc that small steps find free, by rays to all parts of it.
static double free_share(struct d3 p, struct d3 light)
{
    enum { RINGS = 4, TURNS = 12 };
    double sum = 0.0;
    for (int i = 0; i < RINGS * TURNS; i++)
        sum += sees(p, light, disc * sqrt((i / TURNS + 0.5) / RINGS),
                    2.0 * MIRROR_PI * (i % TURNS + 0.5) / TURNS);
    return sum / (RINGS * TURNS);
}

// The quick share on the mountain against rays to the whole disc, where the ends of the disc do not
// agree, in the shadow's rim; elsewhere against one end.
static void test_the_sun_sets_behind_land_by_shares(void **unused)
{
    (void)unused;
    float *values =
        numbers_of("vec2 q = vec2(-12.0, 24.0) + vec2(0.04, 0.05) * pixel, xz = fromValley(q); "
                   "vec4 h = landAt(q, 4.0);"
                   "vec3 n = normalize(vec3(-fromValley(h.yz), 1.0)).xzy, light = "
                   "sunDirection(18.0, LATITUDE, declination);"
                   "Place place = Place(vec3(xz.x, h.x, xz.y), n, vec3(0.0), 0.0, true);"
                   "return vec3(lightSeen(place, light, 0.02), h.x / HIGHEST, dot(n, light));");
    struct d3 light = sun_at(18.0);
    double off[2] = {0.0, 0.0}, hard = 0.0; // elsewhere, in the rim
    int count[2] = {0, 0}, wrong = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i += 23) {
        if (values[4 * i + 1] <= 0.0f || values[4 * i + 2] <= 0.1f) // in the lake, turned away
            continue;
        double x = -12.0 + 0.04 * (i % WIDTH), z = 24.0 + 0.05 * (i / WIDTH),
               share = (double)values[4 * i];
        struct d3 at = world_of(d3(x, highest * (double)values[4 * i + 1] + 0.06, z));
        bool top = sees(at, light, disc, 0.5 * MIRROR_PI),
             rim = top != sees(at, light, disc, -0.5 * MIRROR_PI);
        double right = rim ? free_share(at, light) : (double)top;
        off[rim] += fabs(share - right);
        hard += rim ? fabs(round(right) - right) : 0.0;
        wrong += fabs(share - right) > 0.5;
        count[rim]++;
    }
    free(values);
    print_message("# the sun over the land: at %d places in the shadow's rim the share is off by "
                  "%.4f in the mean, a hard shadow by %.4f; at %d others by %.4f; at %d by more "
                  "than a half\n",
                  count[1], off[1] / count[1], hard / count[1], count[0], off[0] / count[0], wrong);
    assert_true(count[0] > 2000 && count[1] >= 8);
    assert_true(off[0] < 0.0075 * count[0] && off[1] < 0.45 * count[1]);
}

// Where the full moon is mirrored at four in the morning, and five degrees beside it: clouds before
// the moon take its image away, and the water is as bright here as there.
static void test_clouds_hide_the_image_of_the_moon(void **unused)
{
    (void)unused;
    float *clouded = numbers_of("theHour = 4.0; return chapterColour(ray);");
    float *worse = numbers_of("theHour = 4.0; theWeather = 0.75; return chapterColour(ray);");
    double here = (double)clouded[4 * (40 * WIDTH + 591) + 1],
           beside = (double)clouded[4 * (40 * WIDTH + 561) + 1];
    double here2 = (double)worse[4 * (40 * WIDTH + 591) + 1],
           beside2 = (double)worse[4 * (40 * WIDTH + 561) + 1];
    free(clouded);
    free(worse);
    print_message(
        "# the moon's image behind clouds: %.3f, beside it %.3f; in worse weather %.3f, %.3f\n",
        here, beside, here2, beside2);
    assert_true(here < beside + 0.25 && here2 < beside2 + 0.25);
}

// What is shown at 0 and at 24 hours is one picture.
static void test_a_day_is_a_circle(void **unused)
{
    (void)unused;
    float *first = numbers_of("theHour = 0.0; return chapterColour(ray);");
    float *last = numbers_of("theHour = 24.0; return chapterColour(ray);");
    float *noon = numbers_of("theHour = 12.0; return chapterColour(ray);");
    int differ = 0, change = 0;
    for (int i = 0; i < 4 * WIDTH * HEIGHT; i++) {
        differ += fabs((double)first[i] - (double)last[i]) > 0.0;
        change += fabs((double)first[i] - (double)noon[i]) > 0.01;
        assert_true(i % 4 == 3 ||
                    ((double)first[i] >= 0.0 && (double)noon[i] >= 0.0)); // and is a number
    }
    free(first);
    free(last);
    free(noon);
    print_message("# a day: %d channels of 0 h are others at 24 h, %d at 12 h\n", differ, change);
    assert_true(differ == 0 && change > WIDTH * HEIGHT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
        cmocka_unit_test(test_no_land_is_steeper_or_higher_than_is_said),
        cmocka_unit_test(test_the_sun_sets_behind_land_by_shares),
        cmocka_unit_test(test_clouds_hide_the_image_of_the_moon),
        cmocka_unit_test(test_a_day_is_a_circle),
    };
    return cmocka_run_group_tests_name("scene_21", tests, gpu_setup, gpu_teardown);
}
