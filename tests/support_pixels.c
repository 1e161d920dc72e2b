// Pixels of a picture against double precision.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_pixels.h"

enum { WIDTH = 640, HEIGHT = 360 };

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

static void check_pixels(const struct pixel_list *list, const struct mirror_picture *picture,
                         const struct camera *camera, const float *values,
                         const struct image *image)
{
    int count = 0;
    double worst = 0.0;
    for (int i = 0; i < list->count; i++) {
        const struct pixel *pixel = &list->pixel[i];
        if (strcmp(pixel->picture, picture->name) != 0)
            continue;
        check_place(picture, camera, pixel);
        struct mirror_eye eye = eye_at(picture, camera, pixel->x, pixel->y);
        struct d3 colour = picture->sample(&eye).colour;
        const float *v = values + 4 * (pixel->y * WIDTH + pixel->x);
        struct d3 got =
            d3(mirror_clamp((double)v[0]), mirror_clamp((double)v[1]), mirror_clamp((double)v[2]));
        double off = worst_channel(got, colour);
        if (off > list->tolerance)
            print_message("# %s, pixel %d,%d (%s): off by %.2f of 255; expected %.4f %.4f %.4f\n",
                          picture->name, pixel->x, pixel->y, pixel->what, 255.0 * off, colour.x,
                          colour.y, colour.z);
        assert_true(worst_channel(byte_colour(image, pixel), got) <= 0.5001 / 255.0);
        worst = fmax(worst, off);
        count++;
    }
    print_message("# %s: %d pixels, worst %.3f of 255\n", picture->name, count, 255.0 * worst);
    assert_true(count >= 5);
    assert_true(worst <= list->tolerance);
}

void pixels_check(const struct mirror_picture *picture, const struct pixel_list *list)
{
    struct image image = {0};
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .time = picture->time, .samples = 1};
    assert_true(mirror_camera(gpu.root, picture->chapter, &inputs.camera));
    assert_true(gpu_load(picture->shader));
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    float *values = gpu_numbers(&inputs);
    assert_non_null(values);
    check_pixels(list, picture, &inputs.camera, values, &image);
    free(values);
    image_free(&image);
}

void pixels_check_chapter(const char *stem,
                          struct mirror_sample (*sample)(const struct mirror_eye *eye),
                          const struct pixel *pixel, size_t count)
{
    char shader[256];
    snprintf(shader, sizeof shader, "chapters/%s.frag", stem);
    const struct mirror_picture picture = {
        .name = stem, .shader = shader, .chapter = stem, .sample = sample};
    const struct pixel_list list = {pixel, (int)count, 0.1 / 255.0};
    pixels_check(&picture, &list);
}
