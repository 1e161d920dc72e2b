// Unit tests of shaders/textures/paint.c, the pen of the textures, and a look at the pictures: that
// they repeat without a seam. tests/test_textures.sh draws them again.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../shaders/textures/paint.h"
#include "../shaders/textures/weave.h"
#include "support_compare.h"

#define FOLDER "shaders/textures"

// ---- Colour ----

static double srgb_of(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1.0 / 2.4) - 0.055;
}

static void colours_are_decoded_as_srgb_says(void **state)
{
    (void)state;
    for (uint32_t byte = 0; byte < 256; byte++) {
        double value[3], v = byte / 255.0;
        double light = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
        paint_colour(byte << 16 | (255U - byte) << 8 | byte, value);
        assert_true(fabs(value[0] - light) < 1e-14 && value[2] == value[0]);
        assert_int_equal(paint_byte(value[0]), byte);
        assert_int_equal(paint_byte(value[1]), 255U - byte);
        assert_true(paint_light((int)byte) == value[0]);
    }
}

static void a_light_becomes_the_nearest_byte(void **state)
{
    (void)state;
    for (int i = 0; i <= 100000; i++) {
        double light = i / 100000.0, exact = 255.0 * srgb_of(light);
        assert_true(fabs(paint_byte(light) - exact) < 0.5 + 1e-4);
    }
    assert_int_equal(paint_byte(-0.5), 0);
    assert_int_equal(paint_byte(1.5), 255);
}

static void a_scale_is_straight_in_light(void **state)
{
    (void)state;
    const uint32_t code[3] = {0x000000, 0x804020, 0xffffff};
    double at[3], middle[3];
    paint_colour(0x804020, middle);
    for (int c = 0; c < 3; c++) {
        paint_scale(3, code, 0.25, at);
        assert_true(fabs(at[c] - 0.5 * middle[c]) < 1e-15);
        paint_scale(3, code, 0.75, at);
        assert_true(fabs(at[c] - 0.5 * (middle[c] + 1.0)) < 1e-15);
        paint_scale(3, code, 7.0, at);
        assert_true(at[c] == 1.0);
        paint_scale(3, code, -7.0, at);
        assert_true(at[c] == 0.0);
    }
}

// ---- Real arithmetic ----

static void the_exponential_is_that_of_the_library(void **state)
{
    (void)state;
    for (int i = -70000; i <= 70000; i++) {
        double x = i / 100.0 + 1e-4 * (i % 7), exact = exp(x);
        assert_true(x > 700.0 || x < -700.0 || fabs(paint_exp(x) - exact) <= 1e-14 * exact);
    }
    assert_true(paint_exp(0.0) == 1.0);
    assert_true(paint_exp(-1e4) == 0.0);
    assert_true(paint_exp(1e4) == paint_exp(700.0));
}

// ---- Chance ----

// Each bit that is turned in what goes in turns each bit that comes out in about half of the cases:
// 1024 cases have a standard deviation of 16, and the 32 x 96 counts stay within five of them.
static void every_bit_matters(void **state)
{
    (void)state;
    enum { CASES = 1024 };
    for (int in = 0; in < 96; in++) {
        int turned[32] = {0};
        for (int n = 0; n < CASES; n++) {
            uint32_t from[3] = {(uint32_t)n, (uint32_t)(7 * n + 3), (uint32_t)(n % 5)}, to[3];
            memcpy(to, from, sizeof to);
            to[in / 32] ^= 1U << in % 32;
            uint32_t change = paint_hash((int)from[0], (int)from[1], from[2]) ^
                              paint_hash((int)to[0], (int)to[1], to[2]);
            for (int out = 0; out < 32; out++)
                turned[out] += (int)(change >> out & 1U);
        }
        for (int out = 0; out < 32; out++)
            assert_in_range(turned[out], CASES / 2 - 80, CASES / 2 + 80);
    }
}

// The mean of n numbers that are even in [0, 1) is 1/2 +- 1/sqrt(12 n).
static void random_numbers_are_even(void **state)
{
    (void)state;
    enum { SIDE = 256 };
    double sum = 0.0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double r = paint_random(i % SIDE, i / SIDE, 1);
        assert_true(r >= 0.0 && r < 1.0);
        sum += r;
    }
    assert_true(fabs(sum / (SIDE * SIDE) - 0.5) < 4.0 / sqrt(12.0 * SIDE * SIDE));
}

// ---- Patterns ----

// Points that a double holds exactly, also one period on.
static double place(int i, uint32_t seed)
{
    return (double)(paint_hash(i, 0, seed) >> 12) / 1048576.0;
}

static void patterns_have_the_period_1(void **state)
{
    (void)state;
    for (int i = 0; i < 2000; i++) {
        double u = place(i, 1), v = place(i, 2);
        for (int k = 1; k < 4; k++) {
            double up = u + (k & 1), right = v - (k >> 1);
            assert_true(paint_noise(u, v, 7, 12, 3) == paint_noise(up, right, 7, 12, 3));
            assert_true(paint_octaves(u, v, 5, 3, 4, 3) == paint_octaves(up, right, 5, 3, 4, 3));
            struct paint_grain a = paint_grain(u, v, 8, 16, 3);
            struct paint_grain b = paint_grain(up, right, 8, 16, 3);
            assert_true(a.name == b.name && a.edge == b.edge);
            struct weave c = weave_at(u, v), d = weave_at(up, right);
            assert_true(c.warp == d.warp && c.thread == d.thread);
            assert_true(fabs(c.height - d.height) < 1e-9);
        }
    }
}

// At a corner the noise is that corner's number; between two it is never outside of them, and in
// the middle of a cell it is the mean of four.
static void noise_joins_the_corners(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++)
        for (int j = 0; j < 4; j++) {
            double corner = paint_random(i, j, 5), mean = 0.0;
            assert_true(paint_noise(i / 8.0, j / 4.0, 8, 4, 5) == corner);
            for (int k = 0; k < 4; k++)
                mean += 0.25 * paint_random((i + k % 2) % 8, (j + k / 2) % 4, 5);
            assert_true(fabs(paint_noise((i + 0.5) / 8.0, (j + 0.5) / 4.0, 8, 4, 5) - mean) <
                        1e-15);
            double next = paint_random((i + 1) % 8, j, 5), low = fmin(corner, next);
            double between = paint_noise((i + 0.3) / 8.0, j / 4.0, 8, 4, 5);
            assert_true(between >= low && between <= fmax(corner, next));
        }
}

// The step's slope, 30 t^2 (1 - t)^2, by central differences; its integral is 1/2.
static void the_step_is_smooth(void **state)
{
    (void)state;
    double sum = 0.0;
    for (int i = 0; i < 1000; i++) {
        double t = (i + 0.5) / 1000.0, h = 1e-5;
        double slope = (paint_step(2.0, 4.0, 2.0 + 2.0 * (t + h)) -
                        paint_step(2.0, 4.0, 2.0 + 2.0 * (t - h))) /
                       (2.0 * h);
        assert_true(fabs(slope - 30.0 * t * t * (1.0 - t) * (1.0 - t)) < 1e-6);
        sum += paint_step(0.0, 1.0, t) / 1000.0;
    }
    assert_true(fabs(sum - 0.5) < 1e-12);
    assert_true(paint_step(2.0, 4.0, 1.0) == 0.0 && paint_step(2.0, 4.0, 5.0) == 1.0);
}

// Every grain of three periods in each direction is asked.
static void a_grain_is_the_nearest_of_all(void **state)
{
    (void)state;
    enum { SIDE = 6, SEED = 9 };
    for (int i = 0; i < 2000; i++) {
        double u = place(i, 3), v = place(i, 4), first = 1e9, second = 1e9;
        for (int k = 0; k < 9 * SIDE * SIDE; k++) {
            int column = k % (3 * SIDE) - SIDE, row = k / (3 * SIDE) - SIDE;
            uint32_t name = paint_hash((column + SIDE) % SIDE, (row + SIDE) % SIDE, SEED);
            double x = column + (name & 1023U) / 1024.0, y = row + (name >> 10 & 1023U) / 1024.0;
            double d = hypot(u * SIDE - x, v * SIDE - y) - 0.5 * (name >> 20 & 1023U) / 1024.0;
            second = fmin(second, fmax(first, d));
            first = fmin(first, d);
        }
        struct paint_grain grain = paint_grain(u, v, SIDE, SIDE, SEED);
        assert_true(fabs(grain.edge - 0.5 * (second - first)) < 1e-12);
    }
}

// Over, under, over: at the crossings the threads that lie above are a checkerboard.
static void threads_lie_over_and_under(void **state)
{
    (void)state;
    int crossings = 0, regular = 0;
    for (int i = 0; i < WEAVE_THREADS; i++)
        for (int j = 0; j < WEAVE_THREADS; j++) {
            struct weave at = weave_at((i + 0.5) / WEAVE_THREADS, (j + 0.5) / WEAVE_THREADS);
            assert_true(at.height >= 0.0 && at.height <= 1.0);
            crossings += at.covered;
            regular += at.covered && at.warp == ((i + j) % 2 == 0);
        }
    // Threads bend by up to 0.4 of their distance, so that some points are no crossing.
    assert_true(crossings > 0.95 * WEAVE_THREADS * WEAVE_THREADS);
    assert_true(regular > 0.9 * crossings);
}

// ---- The pictures ----

// A picture as a volume: one slice, or square slices one below the other.
static int slices_of(const struct image *image)
{
    return image->height > image->width && image->height % image->width == 0
               ? image->height / image->width
               : 1;
}

// The mean difference between two neighbouring layers of a volume, layer at and the next one, which
// after the last one is the first.
//   axis  0 for columns, 1 for rows, 2 for slices
static double step_across(const struct image *image, int axis, int at)
{
    int slices = slices_of(image), size[3] = {image->width, image->height / slices, slices};
    int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
    double sum = 0.0;
    for (int i = 0; i < size[a] * size[b]; i++) {
        int here[3], there[3];
        here[a] = there[a] = i % size[a];
        here[b] = there[b] = i / size[a];
        here[axis] = at;
        there[axis] = (at + 1) % size[axis];
        const unsigned char *p =
            image->pixel + 3 * (here[0] + size[0] * (here[1] + size[1] * here[2]));
        const unsigned char *q =
            image->pixel + 3 * (there[0] + size[0] * (there[1] + size[1] * there[2]));
        for (int c = 0; c < 3; c++)
            sum += abs(p[c] - q[c]);
    }
    return sum / (3.0 * size[a] * size[b]);
}

// True when the step from the last layer to the first is none that does not occur inside.
static bool repeats(const struct image *image, int axis)
{
    int slices = slices_of(image), size[3] = {image->width, image->height / slices, slices};
    double largest = 0.0;
    for (int at = 0; at < size[axis] - 1; at++)
        largest = fmax(largest, step_across(image, axis, at));
    return size[axis] == 1 || step_across(image, axis, size[axis] - 1) <= largest;
}

// The picture without its right part.
static struct image cropped(const struct image *image, int width)
{
    struct image part;
    assert_true(image_create(&part, width, image->height));
    for (int y = 0; y < image->height; y++)
        memcpy(part.pixel + 3 * width * y, image->pixel + 3 * image->width * y, 3 * (size_t)width);
    return part;
}

// 8 bits a channel, grey or RGB, with a fourth number or without, not interlaced: what every reader
// of PNG reads.
static void assert_plain(const char *path)
{
    unsigned char head[29];
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(fread(head, 1, sizeof head, file), sizeof head);
    fclose(file);
    assert_int_equal(head[24], 8);
    assert_true(head[25] == 0 || head[25] == 2 || head[25] == 6);
    assert_int_equal(head[28], 0);
}

// A table ends where it ends: its program says in its first comment that it is read with clamp.
static bool is_clamped(const char *path)
{
    char source[256], line[256];
    snprintf(source, sizeof source, "%.*s.c", (int)(strlen(path) - strlen(".png")), path);
    FILE *file = fopen(source, "r");
    assert_non_null(file);
    bool clamped = false;
    while (fgets(line, sizeof line, file) != NULL && strncmp(line, "//", 2) == 0)
        clamped = clamped || strstr(line, " clamp") != NULL;
    fclose(file);
    return clamped;
}

static void look_at(const char *path)
{
    struct image image;
    assert_plain(path);
    if (is_clamped(path))
        return;
    assert_true(image_read_png(&image, path));
    for (int axis = 0; axis < 3; axis++)
        if (!repeats(&image, axis))
            fail_msg("%s has a seam, axis %d", path, axis);
    // A picture that does not repeat is seen.
    struct image part = cropped(&image, image.width - image.width / 10);
    if (slices_of(&image) == 1 && repeats(&part, 0))
        fail_msg("%s: no seam is seen where a tenth is cut off", path);
    image_free(&part);
    image_free(&image);
}

static void pictures_repeat_without_a_seam(void **state)
{
    (void)state;
    DIR *folder = opendir(FOLDER);
    assert_non_null(folder);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        char path[sizeof FOLDER + 1 + sizeof entry->d_name];
        snprintf(path, sizeof path, "%s/%s", FOLDER, entry->d_name);
        if (strstr(entry->d_name, ".png") == NULL)
            continue;
        look_at(path);
        count++;
    }
    closedir(folder);
    assert_true(count >= 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colours_are_decoded_as_srgb_says),
        cmocka_unit_test(a_light_becomes_the_nearest_byte),
        cmocka_unit_test(a_scale_is_straight_in_light),
        cmocka_unit_test(the_exponential_is_that_of_the_library),
        cmocka_unit_test(every_bit_matters),
        cmocka_unit_test(random_numbers_are_even),
        cmocka_unit_test(patterns_have_the_period_1),
        cmocka_unit_test(noise_joins_the_corners),
        cmocka_unit_test(the_step_is_smooth),
        cmocka_unit_test(a_grain_is_the_nearest_of_all),
        cmocka_unit_test(threads_lie_over_and_under),
        cmocka_unit_test(pictures_repeat_without_a_seam),
    };
    return cmocka_run_group_tests_name("paint", tests, NULL, NULL);
}
