// test_pixels.c - pixels of every chapter and first step against a colour computed in double
// precision by another text: its own march, to the limit, its own normals and shading.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_gpu.h"
#include "support_mirror.h"

enum { WIDTH = 640, HEIGHT = 360 };

// The march ends up to a threshold before the surface, which moves a shaded colour by at most 0.06
// of 255 here. Where the normal itself is the colour more is seen: 0.001 before a ball of radius
// 0.16 the normal may turn by 1.6 of 255; 0.42 at these pixels.
static double tolerance_of(const char *picture)
{
    return (strcmp(picture, "01_normal_colouring") == 0 ? 0.5 : 0.1) / 255.0;
}

// A pixel, 0,0 bottom left, and what stands there, so that the choice keeps covering the scene.
struct pixel {
    const char *picture;
    int x, y;
    const char
        *what; // the part, then '+' lit, '-' turned away (or unlit by any lamp), '#' in shadow
};

static const struct pixel pixels[] = {
    {"00_first_scene", 214, 338, "sky-"},
    {"00_first_scene", 304, 172, "ball+"},
    {"00_first_scene", 320, 174, "ball+"},
    {"00_first_scene", 352, 102, "frame+"},
    {"00_first_scene", 374, 218, "frame+"},
    {"00_first_scene", 424, 174, "sky-"},
    {"01_normal_colouring", 158, 116, "orbit 3-"},
    {"01_normal_colouring", 174, 120, "orbit 3-"},
    {"01_normal_colouring", 190, 198, "orbit 4-"},
    {"01_normal_colouring", 200, 198, "orbit 4-"},
    {"01_normal_colouring", 234, 64, "orbit 2-"},
    {"01_normal_colouring", 250, 34, "orbit 2-"},
    {"01_normal_colouring", 300, 210, "ball-"},
    {"01_normal_colouring", 310, 246, "sky-"},
    {"01_normal_colouring", 312, 84, "frame-"},
    {"01_normal_colouring", 314, 156, "ball-"},
    {"01_normal_colouring", 340, 244, "orbit 6-"},
    {"01_normal_colouring", 342, 242, "orbit 6-"},
    {"01_normal_colouring", 354, 204, "frame-"},
    {"01_normal_colouring", 400, 56, "orbit 1-"},
    {"01_normal_colouring", 404, 54, "orbit 1-"},
    {"01_normal_colouring", 418, 206, "orbit 7-"},
    {"01_normal_colouring", 418, 220, "orbit 7-"},
    {"01_normal_colouring", 570, 184, "sky-"},
    {"02_lighting", 164, 326, "sky-"},
    {"02_lighting", 232, 196, "block-"},
    {"02_lighting", 240, 176, "block-"},
    {"02_lighting", 264, 90, "stage-"},
    {"02_lighting", 270, 210, "block+"},
    {"02_lighting", 274, 200, "block+"},
    {"02_lighting", 288, 100, "stage+"},
    {"02_lighting", 296, 78, "stage-"},
    {"02_lighting", 314, 338, "sky-"},
    {"02_lighting", 332, 256, "frame+"},
    {"02_lighting", 336, 258, "frame+"},
    {"02_lighting", 342, 84, "stage+"},
    {"02_lighting", 358, 214, "inside-"},
    {"02_lighting", 358, 242, "frame-"},
    {"02_lighting", 366, 200, "inside-"},
    {"02_lighting", 366, 284, "above-"},
    {"02_lighting", 368, 290, "above-"},
    {"02_lighting", 372, 240, "frame-"},
    {"02_lighting", 400, 116, "resting-"},
    {"02_lighting", 402, 116, "resting-"},
    {"03_shadows", 18, 104, "sky-"},
    {"03_shadows", 230, 196, "block-"},
    {"03_shadows", 234, 186, "block-"},
    {"03_shadows", 262, 192, "block#"},
    {"03_shadows", 264, 190, "block#"},
    {"03_shadows", 278, 192, "block+"},
    {"03_shadows", 282, 192, "block+"},
    {"03_shadows", 300, 76, "stage-"},
    {"03_shadows", 308, 136, "stage#"},
    {"03_shadows", 326, 66, "stage-"},
    {"03_shadows", 350, 112, "stage+"},
    {"03_shadows", 358, 242, "frame-"},
    {"03_shadows", 360, 210, "inside-"},
    {"03_shadows", 366, 282, "above-"},
    {"03_shadows", 368, 196, "inside-"},
    {"03_shadows", 368, 276, "above-"},
    {"03_shadows", 372, 86, "stage#"},
    {"03_shadows", 380, 210, "inside#"},
    {"03_shadows", 382, 212, "inside#"},
    {"03_shadows", 398, 118, "resting-"},
    {"03_shadows", 398, 192, "frame-"},
    {"03_shadows", 420, 104, "resting-"},
    {"03_shadows", 446, 66, "stage+"},
    {"03_shadows", 490, 240, "sky-"},
    {"1_screen", 124, 206, "screen-"},
    {"1_screen", 230, 156, "screen-"},
    {"1_screen", 350, 236, "screen-"},
    {"1_screen", 40, 314, "screen-"},
    {"1_screen", 440, 244, "screen-"},
    {"2_distance", 210, 228, "inside-"},
    {"2_distance", 222, 162, "inside-"},
    {"2_distance", 24, 334, "outside-"},
    {"2_distance", 240, 330, "outside-"},
    {"2_distance", 258, 202, "inside-"},
    {"2_distance", 28, 56, "outside-"},
    {"3_ray", 124, 206, "ray-"},
    {"3_ray", 230, 156, "ray-"},
    {"3_ray", 350, 236, "ray-"},
    {"3_ray", 40, 314, "ray-"},
    {"3_ray", 440, 244, "ray-"},
    {"4_march", 146, 312, "sky-"},
    {"4_march", 164, 204, "sky-"},
    {"4_march", 188, 330, "sky-"},
    {"4_march", 246, 110, "ground-"},
    {"4_march", 274, 200, "ball-"},
    {"4_march", 278, 228, "ball-"},
    {"4_march", 302, 182, "ball-"},
    {"4_march", 304, 12, "ground-"},
    {"4_march", 368, 68, "ground-"},
    {"5_light", 148, 112, "ground+"},
    {"5_light", 266, 232, "ball+"},
    {"5_light", 342, 196, "ball+"},
    {"5_light", 376, 138, "ball-"},
    {"5_light", 384, 172, "ball-"},
    {"5_light", 474, 34, "ground+"},
    {"5_light", 532, 196, "sky-"},
    {"5_light", 578, 124, "ground+"},
    {"5_light", 82, 324, "sky-"},
};

enum { PIXELS = sizeof pixels / sizeof pixels[0] };

static struct gpu gpu;

static int open_gpu(void **unused)
{
    (void)unused;
    return gpu_open(&gpu) ? 0 : -1;
}

static int close_gpu(void **unused)
{
    (void)unused;
    gpu_close(&gpu);
    return 0;
}

static struct mirror_eye eye_at(const struct mirror_picture *picture, const struct camera *camera,
                                int x, int y)
{
    return (struct mirror_eye){.camera = *camera,
                               .time = picture->time,
                               .x = mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                               .y = mirror_screen_y(y + 0.5, HEIGHT)};
}

static void name_of(const struct mirror_sample *sample, char *name, size_t size)
{
    snprintf(name, size, "%s%c", sample->what,
             sample->shadowed ? '#' : (sample->faces ? '+' : '-'));
}

// The pixel and all within two pixels of it show the same thing, and it is the one listed.
static void check_place(const struct mirror_picture *picture, const struct camera *camera,
                        const struct pixel *pixel)
{
    for (int dy = -2; dy <= 2; dy++)
        for (int dx = -2; dx <= 2; dx++) {
            char name[64];
            struct mirror_eye eye = eye_at(picture, camera, pixel->x + dx, pixel->y + dy);
            struct mirror_sample sample = picture->sample(&eye);
            name_of(&sample, name, sizeof name);
            assert_string_equal(name, pixel->what);
        }
}

static double worst_channel(struct d3 got, struct d3 colour)
{
    return fmax(fabs(got.x - colour.x), fmax(fabs(got.y - colour.y), fabs(got.z - colour.z)));
}

// The picture's bytes are the numbers of the float target, rounded.
static struct d3 byte_colour(const struct image *image, const struct pixel *pixel)
{
    const unsigned char *v = image->pixel + 3 * ((HEIGHT - 1 - pixel->y) * WIDTH + pixel->x);
    return d3(v[0] / 255.0, v[1] / 255.0, v[2] / 255.0);
}

static void check_pixels(const struct mirror_picture *picture, const struct camera *camera,
                         const float *values, const struct image *image)
{
    int count = 0;
    double worst = 0.0;
    for (int i = 0; i < PIXELS; i++) {
        const struct pixel *pixel = &pixels[i];
        if (strcmp(pixel->picture, picture->name) != 0)
            continue;
        check_place(picture, camera, pixel);
        struct mirror_eye eye = eye_at(picture, camera, pixel->x, pixel->y);
        struct d3 colour = picture->sample(&eye).colour;
        const float *v = values + 4 * (pixel->y * WIDTH + pixel->x);
        struct d3 got =
            d3(mirror_clamp((double)v[0]), mirror_clamp((double)v[1]), mirror_clamp((double)v[2]));
        double off = worst_channel(got, colour);
        if (off > tolerance_of(picture->name))
            print_message("# %s, pixel %d,%d (%s): off by %.2f of 255; expected %.4f %.4f %.4f\n",
                          picture->name, pixel->x, pixel->y, pixel->what, 255.0 * off, colour.x,
                          colour.y, colour.z);
        assert_true(worst_channel(byte_colour(image, pixel), got) <= 0.5001 / 255.0);
        worst = fmax(worst, off);
        count++;
    }
    print_message("# %s: %d pixels, worst %.3f of 255\n", picture->name, count, 255.0 * worst);
    assert_true(count >= 5);
    assert_true(worst <= tolerance_of(picture->name));
}

static void check_picture(const struct mirror_picture *picture)
{
    struct image image = {0};
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .time = picture->time, .samples = 1};
    assert_true(mirror_camera(gpu.root, picture->chapter, &inputs.camera));
    assert_true(gpu_load(&gpu, picture->shader));
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    float *values = gpu_numbers(&gpu, &inputs);
    assert_non_null(values);
    check_pixels(picture, &inputs.camera, values, &image);
    free(values);
    image_free(&image);
}

static void check_named(const char *name)
{
    const struct mirror_picture *picture = mirror_find(name);
    assert_non_null(picture);
    check_picture(picture);
}

static void test_first_steps(void **unused)
{
    (void)unused;
    check_named("1_screen");
    check_named("2_distance");
    check_named("3_ray");
    check_named("4_march");
    check_named("5_light");
}

static void test_chapter_00(void **unused)
{
    (void)unused;
    check_named("00_first_scene");
}

static void test_chapter_01(void **unused)
{
    (void)unused;
    check_named("01_normal_colouring");
}

static void test_chapter_02(void **unused)
{
    (void)unused;
    check_named("02_lighting");
}

static void test_chapter_03(void **unused)
{
    (void)unused;
    check_named("03_shadows");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_first_steps), cmocka_unit_test(test_chapter_00),
        cmocka_unit_test(test_chapter_01),  cmocka_unit_test(test_chapter_02),
        cmocka_unit_test(test_chapter_03),
    };
    return cmocka_run_group_tests_name("pixels", tests, open_gpu, close_gpu);
}
