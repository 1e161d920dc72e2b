// test_scene_20.c - chapter 20 in double precision: pixels of rock, tower and house in the evening
// sun, clouds as the panorama has them, and the seam that the hardware draws.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../common/picture/image.h"
#include "support_noise.h"
#include "support_pixels.h"

#define CHAPTER "20_clouds_and_weather"

enum { WIDTH = 640, HEIGHT = 360, MAX_STEPS = 96, COLUMNS = 2048, ROWS = 320 };

static const double threshold = 0.002, rise = 0.56;
static const double pixel_spread = 1.0 / (HEIGHT * MIRROR_FOCAL_LENGTH);
static const struct d3 tower = {-15.5, 1.5, -6.4}, house = {-16.0, 2.0, -8.9};

// ---- The coast ----

static double smooth_union(double a, double b, double k)
{
    double h = fmax(k - fabs(a - b), 0.0);
    return fmin(a, b) - h * h * h / (6.0 * k * k);
}

static double fold(double x)
{
    return fabs(x - floor(x) - 0.5);
}

static double ball(struct d3 p, double x, double y, double z, double radius)
{
    return d3_length(d3_sub(p, d3(x, y, z))) - radius;
}

static double rock_distance(struct d3 p)
{
    double a = fold(0.47 * p.x + 0.21 * p.z), b = fold(0.9 * p.y + 0.21 * p.x);
    double c = fold(0.61 * p.z + 0.21 * p.y);
    double cape = fmax(hypot(p.x + 16.0, p.z + 8.6) - 3.9, p.y - 1.5);
    double hill = fmax(hypot(p.x + 16.6, p.z + 14.4) - 5.4, p.y - 2.4 + 0.12 * fabs(p.z + 15.0));
    double d = smooth_union(smooth_union(cape, hill, 1.4), ball(p, -13.6, -0.7, -4.9, 1.5), 0.6);
    d = fmin(d, ball(p, -13.9, -0.6, -2.3, 0.85));
    return (d - 0.2 + a * c + 0.2 * b + 0.2 * c) / 1.9;
}

static double tower_distance(struct d3 p)
{
    double r = hypot(p.x - tower.x, p.z - tower.z), y = p.y - tower.y;
    double body = fmax(0.9979 * (r - 0.6 + 0.0636 * (y - 2.2)), fabs(y - 2.2) - 2.2);
    double gallery = fmax(r - 0.68, fabs(y - 4.46) - 0.06);
    double lantern = fmax(r - 0.36, fabs(y - 4.9) - 0.4);
    double roof = fmax(sqrt(0.5) * (r + y - 5.76), 5.28 - y);
    return fmin(fmin(body, gallery), fmin(lantern, roof));
}

static double house_distance(struct d3 p)
{
    struct d3 q = d3_sub(p, house);
    double x = fabs(q.x), y = q.y - 0.5, z = fabs(q.z);
    double roof = fmax(0.6 * (x - 0.8) + 0.8 * (y + 0.05), fmax(-y, z - 1.2));
    double d = fmin(brute_box(q, d3(0.7, 0.5, 1.1)), roof);
    return fmin(d, brute_box(d3_sub(q, d3(0.1, 1.0, -0.8)), d3(0.14, 0.36, 0.16)));
}

static double distance_of(struct d3 p, int *nearest)
{
    const double part[3] = {rock_distance(p), tower_distance(p), house_distance(p)};
    return mirror_nearest(part, 3, nearest);
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

// Both boxes as one way: from where the first begins to where the last ends.
static bool coast_interval(struct mirror_ray ray, double t[2])
{
    double a[2], b[2];
    struct d3 room = d3(0.76, 0.0, 0.76);
    bool first =
        brute_box_interval(ray, d3(-22.5, -0.1, -21.0), d3(-10.8, 3.4, -1.4), a) && a[0] < a[1];
    bool second = brute_box_interval(ray, d3_sub(d3_sub(tower, room), d3(0.0, 0.5, 0.0)),
                                     d3_add(d3_add(tower, room), d3(0.0, 5.8, 0.0)), b) &&
                  b[0] < b[1];
    t[0] = first && second ? fmin(a[0], b[0]) : first ? a[0] : b[0];
    t[1] = first && second ? fmax(a[1], b[1]) : first ? a[1] : b[1];
    return first || second;
}

// ---- The light of the evening ----

static double air_mass(double y)
{
    double climb = 721.5 * fmax(y, 0.0), whole = 2.0 * 721.5 + 1.0;
    return whole / (sqrt(climb * climb + whole) + climb);
}

static struct d3 sun_direction(double hour)
{
    double h = 15.0 * (hour - 12.0) * MIRROR_PI / 180.0, p = 43.6 * MIRROR_PI / 180.0;
    double d = -8.0 * MIRROR_PI / 180.0;
    return d3(cos(p) * sin(d) - sin(p) * cos(d) * cos(h),
              sin(p) * sin(d) + cos(p) * cos(d) * cos(h), -cos(d) * sin(h));
}

static struct d3 sunlight(double y)
{
    double m = air_mass(y), in = mirror_smoothstep(-0.012, 0.03, y);
    return d3_times(in, d3(11.5 * exp(-0.1 * m), 10.3 * exp(-0.148 * m), 9.9 * exp(-0.269 * m)));
}

static struct d3 skylight(double y)
{
    double bright = exp2(-0.41 - 0.352 / (y + 0.1)), high = y / (y + 0.1);
    return d3(bright * (0.92 - 0.19 * high) + 6e-8, bright * 1.02 + 6e-8,
              bright * (1.08 + 0.5 * high) + 6e-8);
}

static double film_of(double x)
{
    double g = pow(0.18, 1.3), w = pow(6.0, 1.3), k = 0.82 * g * w / (0.18 * w - g);
    return (1.0 + k / w) / (1.0 + k / pow(fmin(x, 6.0), 1.3));
}

static struct d3 developed(struct d3 light, double stops)
{
    struct d3 x = d3_times(exp2(stops), light);
    double largest = fmax(x.x, fmax(x.y, x.z)), share = film_of(largest) / largest;
    return d3(mirror_encode(share * x.x), mirror_encode(share * x.y), mirror_encode(share * x.z));
}

static double coverage(double inside, double width)
{
    return mirror_clamp(inside / (width + 0.001) + 0.5);
}

static struct d3 mix(struct d3 a, struct d3 b, double share)
{
    return d3_add(d3_times(1.0 - share, a), d3_times(share, b));
}

static const struct d3 white = {0.78, 0.75, 0.70};

static struct d3 tower_colour(struct d3 p, double width)
{
    double y = p.y - tower.y;
    double band = coverage(0.55 - fabs(y - 2.6), width) + coverage(y - 5.26, width) +
                  coverage(0.12 - fabs(y - 4.42), width);
    struct d3 painted = mix(white, d3(0.42, 0.05, 0.035), fmin(band, 1.0));
    return mix(painted, d3(0.05, 0.05, 0.05), coverage(0.3 - fabs(y - 4.92), width));
}

static struct d3 house_colour(struct d3 p, double width)
{
    struct d3 r = d3_sub(p, house);
    double panes = r.x > 0.65 ? coverage(0.14 - fabs(fabs(r.z - 0.1) - 0.5), width) *
                                    coverage(0.18 - fabs(r.y - 0.05), width)
                              : 0.0;
    return mix(r.y > 0.47 && r.y < 1.05 ? d3(0.14, 0.13, 0.15) : white, d3(0.03, 0.03, 0.03),
               panes);
}

static struct d3 rock_colour(struct d3 p, double tone, struct d3 normal)
{
    double wet = 0.25 + 0.75 * mirror_smoothstep(0.0, 0.5, p.y);
    struct d3 stone = d3_times(wet, mix(d3(0.13, 0.11, 0.10), d3(0.42, 0.36, 0.30), tone));
    struct d3 turf = mix(d3(0.09, 0.09, 0.03), d3(0.18, 0.15, 0.06), tone);
    return mix(stone, turf,
               mirror_smoothstep(0.55, 0.85, normal.y) *
                   mirror_smoothstep(1.0, 1.5, p.y + 0.5 * tone));
}

static struct mirror_sample sample_20(const struct mirror_eye *eye)
{
    static const char *const names[] = {"rock", "tower", "house"};
    struct mirror_sample sample = {.what = "sky"};
    struct mirror_ray ray =
        mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y + rise);
    double way[2], sea = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 1e5, t = 0.0;
    bool found = false;
    if (coast_interval(ray, way)) {
        t = way[0];
        for (int step = 0; step < MAX_STEPS && t < fmin(way[1], sea) && !found; step++) {
            double h = distance_of(mirror_at(ray, t), NULL);
            found = h < threshold + pixel_spread * t;
            t += found ? 0.0 : h;
        }
    }
    if (!found)
        return sample;
    struct d3 p = mirror_at(ray, t), normal = normal_at(p, threshold + pixel_spread * t);
    double width = 2.0 * pixel_spread * t;
    int part = 0;
    distance_of(p, &part);
    struct noise grain = noise_value(d3(1.7 * p.x, 7.0 * p.y, 1.7 * p.z));
    if (part == 0) {
        struct d3 slope = d3_times(0.055, d3_product(d3(1.7, 7.0, 1.7), grain.gradient));
        slope = d3_sub(slope, d3_times(d3_dot(slope, normal), normal));
        normal = d3_unit(d3_sub(normal, slope));
    }
    struct d3 sun = sun_direction(16.9), sky = skylight(sun.y);
    double facing = mirror_lambert(normal, sun), lit = 1.0;
    struct mirror_ray up = {d3_add(p, d3_times(0.02 + width, normal)), sun};
    if (facing > 0.0 && coast_interval(up, way)) {
        double s = way[0];
        for (int step = 0; step < 32 && s < way[1] && lit > 0.0; step++) {
            double h = distance_of(mirror_at(up, s), NULL);
            lit = h < 0.01 ? 0.0 : 1.0;
            s += h;
        }
    }
    struct d3 colour = part == 0   ? rock_colour(p, grain.value, normal)
                       : part == 1 ? tower_colour(p, width)
                                   : house_colour(p, width);
    struct d3 open =
        d3_add(d3_times(0.6 + 0.4 * normal.y, sky), d3_times(lit * facing, sunlight(sun.y)));
    // Of the lamps nothing is on yet: the sky's light is above 0.15.
    assert_true(sky.y > 0.15);
    sample.what = names[part];
    sample.faces = facing > 0.0;
    sample.shadowed = lit < 0.5;
    sample.colour = developed(d3_product(colour, open), -2.2 - 0.85 * log2(sky.y));
    return sample;
}

// ---- Pixels ----

static const struct pixel pixels[] = {
    {CHAPTER, 432, 72, "rock-"},   {CHAPTER, 433, 73, "rock-"},   {CHAPTER, 449, 65, "rock#"},
    {CHAPTER, 462, 90, "tower-"},  {CHAPTER, 463, 91, "tower-"},  {CHAPTER, 464, 92, "tower-"},
    {CHAPTER, 465, 93, "tower-"},  {CHAPTER, 469, 193, "tower-"}, {CHAPTER, 470, 194, "tower-"},
    {CHAPTER, 471, 195, "tower-"}, {CHAPTER, 483, 99, "tower#"},  {CHAPTER, 484, 100, "tower#"},
    {CHAPTER, 491, 107, "house-"}, {CHAPTER, 492, 108, "house-"}, {CHAPTER, 493, 109, "house-"},
    {CHAPTER, 494, 110, "house-"}, {CHAPTER, 495, 111, "house-"}, {CHAPTER, 496, 112, "house-"},
    {CHAPTER, 497, 113, "house-"}, {CHAPTER, 551, 47, "rock-"},   {CHAPTER, 583, 67, "rock-"},
    {CHAPTER, 584, 68, "rock-"},   {CHAPTER, 602, 62, "rock#"},   {CHAPTER, 607, 79, "rock#"},
    {CHAPTER, 608, 80, "rock#"},   {CHAPTER, 609, 81, "rock#"},
};

static void test_pixels_agree_with_double(void **unused)
{
    (void)unused;
    pixels_check_chapter(CHAPTER, sample_20, pixels, sizeof pixels / sizeof *pixels);
}

// Nowhere does the distance grow faster than one moves: no step of the march is too long.
static void test_the_distance_is_1_lipschitz(void **unused)
{
    (void)unused;
    double steepest = 0.0;
    for (int i = 0; i < 60000; i++) {
        struct d3 p =
            d3(-22.0 + 10.0 * fmod(0.754877666 * i, 1.0), 7.0 * fmod(0.569840291 * i, 1.0),
               -20.0 + 18.0 * fmod(0.3819660113 * i, 1.0));
        struct d3 step = d3(0.01 * cos(i), 0.01 * sin(1.7 * i), 0.01 * sin(i));
        double change = distance_of(d3_add(p, step), NULL) - distance_of(p, NULL);
        steepest = fmax(steepest, fabs(change) / d3_length(step));
    }
    print_message("# the coast's distance: steepest %.3f\n", steepest);
    assert_true(steepest <= 1.0 + 1e-6);
}

// Nothing of the coast that stands over the sea stands beside the boxes that its rays are clipped
// to: the nearest that it comes to their outside is printed.
static void test_the_boxes_hold_the_coast(void **unused)
{
    (void)unused;
    double least = 1.0;
    int count = 0;
    for (int i = 0; i < 400000; i++) {
        struct d3 p =
            d3(-24.0 + 15.0 * fmod(0.8191725134 * i, 1.0), 8.0 * fmod(0.6710436067 * i, 1.0),
               -22.0 + 22.0 * fmod(0.5497004779 * i, 1.0));
        struct d3 t = d3_sub(p, tower);
        bool rocks = p.x > -22.5 && p.x < -10.8 && p.y < 3.4 && p.z > -21.0 && p.z < -1.4;
        bool slender = fabs(t.x) < 0.76 && fabs(t.z) < 0.76 && t.y > -0.5 && t.y < 5.8;
        if (rocks || slender)
            continue;
        least = fmin(least, distance_of(p, NULL));
        count++;
    }
    print_message("# outside of the boxes: %d places, the nearest %.3f from the coast\n", count,
                  least);
    assert_true(count > 100000 && least > 0.0);
}

// ---- The sky ----

// Draw a shader that includes the chapter, with the starting camera and so many pans further.
static float *numbers_of(const char *text, double pan)
{
    struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, 1);
    assert_true(mirror_camera(gpu.root, CHAPTER, &inputs.camera));
    inputs.camera.pan += (float)pan;
    assert_true(gpu_load_text(text));
    float *values = gpu_numbers(&inputs);
    assert_non_null(values);
    return values;
}

#define RENAMED                                                                                    \
    "#include \"main.glsl\"\n#define rayColour chapterColour\n"                                    \
    "#include \"20_clouds_and_weather.frag\"\n#undef rayColour\n"

// Straight lines between four texels, as the picture's numbers stand in the file.
static double texel_at(const struct image_bytes *image, double u, double v, int channel)
{
    double x = u * image->width - 0.5, y = (1.0 - v) * image->height - 0.5, i = floor(x);
    double j = floor(y), sum = 0.0;
    for (int k = 0; k < 4; k++) {
        int column = ((int)i + k % 2 + 4 * image->width) % image->width, row = (int)j + k / 2;
        double share = (k % 2 ? x - i : 1.0 - x + i) * (k / 2 ? y - j : 1.0 - y + j);
        sum += share * image->value[3 * (row * image->width + column) + channel] / 255.0;
    }
    return sum;
}

// Between 9 and 16 degrees over the horizon a pixel is smaller than a texel: what is read is level
// 0. The weights of the driver have 8 bits: three steps of 1/256.
static void test_clouds_are_the_panorama_turned(void **unused)
{
    (void)unused;
    struct image_bytes image = {0};
    char path[4200], why[IMAGE_WHY];
    snprintf(path, sizeof path, "%s/shaders/textures/clouds_fair.png", gpu.root);
    assert_true(image_read_bytes(&image, path, 3, 1 << 22, why));
    float *values = numbers_of(
        RENAMED
        "vec3 rayColour(Ray ray) { Cloud c = cloudPanorama(cloudsFair, ray.direction, 0.38, "
        "2.0 * pixelSpread()); return vec3(c.cover, c.above, 0.5 + 0.5 * c.side); }\n",
        0.0);
    struct camera camera;
    assert_true(mirror_camera(gpu.root, CHAPTER, &camera));
    int count = 0;
    double worst = 0.0, spread = 0.0;
    for (int y = 0; y < HEIGHT; y += 3)
        for (int x = 0; x < WIDTH; x += 7) {
            struct d3 d = mirror_screen_ray(&camera, MIRROR_FOCAL_LENGTH,
                                            mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                                            mirror_screen_y(y + 0.5, HEIGHT) + rise)
                              .direction;
            double height = atan2(d.y, hypot(d.x, d.z));
            if (height < 0.157 || height > 0.28)
                continue;
            double u = atan2(d.z, d.x) / (2.0 * MIRROR_PI) + 0.38;
            for (int c = 0; c < 3; c++) {
                double right = texel_at(&image, u, sqrt(2.0 * height / MIRROR_PI), c);
                worst = fmax(worst, fabs((double)values[4 * (y * WIDTH + x) + c] - right));
                spread = fmax(spread, right);
            }
            count++;
        }
    free(values);
    free(image.value);
    print_message("# %d places of the panorama: worst %.4f\n", count, worst);
    assert_true(count > 500 && spread > 0.9 && worst < 3.0 / 256.0);
}

// The largest mean difference, over the rows of the sky, of a column to the next: at the seam, and
// at all others within so many columns of it.
static void steps_at(const float *values, int seam, double *across, double *beside)
{
    *across = *beside = 0.0;
    for (int x = seam - 60; x < seam + 60; x++) {
        double sum = 0.0;
        for (int y = 120; y < HEIGHT; y++)
            for (int c = 0; c < 3; c++)
                sum += fabs((double)values[4 * (y * WIDTH + x) + c] -
                            (double)values[4 * (y * WIDTH + x + 1) + c]) /
                       (3.0 * (HEIGHT - 120));
        double *largest = abs(x - seam) <= 2 ? across : beside;
        *largest = fmax(*largest, sum);
    }
}

// Three degrees to the right of where the panorama ends, it ends three degrees to the left of the
// middle: 360 tan(3 degrees) pixels.
static void test_no_seam_is_drawn(void **unused)
{
    (void)unused;
    double across, beside;
    int seam = WIDTH / 2 - 1 - (int)(HEIGHT * tan(3.0 * MIRROR_PI / 180.0) + 0.5);
    float *values = numbers_of("#include \"20_clouds_and_weather.frag\"\n", 3.0);
    steps_at(values, seam, &across, &beside);
    free(values);
    print_message("# mended: %.4f across the seam, %.4f beside it\n", across, beside);
    assert_true(across <= beside);
    values = numbers_of("#include \"experiments/20_seam.frag\"\n", 3.0);
    steps_at(values, seam, &across, &beside);
    free(values);
    print_message("# the hardware's: %.4f across the seam, %.4f beside it\n", across, beside);
    assert_true(across > 2.0 * beside);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_agree_with_double),
        cmocka_unit_test(test_the_distance_is_1_lipschitz),
        cmocka_unit_test(test_the_boxes_hold_the_coast),
        cmocka_unit_test(test_clouds_are_the_panorama_turned),
        cmocka_unit_test(test_no_seam_is_drawn),
    };
    return cmocka_run_group_tests_name("scene of chapter 20", tests, gpu_setup, gpu_teardown);
}
