// full_size.c - tests that the picture of every chapter at 1920x1080, the size of most screens, has
// no holes where rays ran out of steps.
#include <glob.h>

#include "lib/test.h"
#include "lib/gpu.h"

enum { WIDTH = 1920, HEIGHT = 1080 };

static struct image drawn(const struct camera *camera)
{
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .samples = 1, .camera = *camera};
    struct image image = {0};
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    return image;
}

// The number of pixels of which a channel differs by more than 2 of 255.
static int different(const struct image *a, const struct image *b)
{
    int count = 0;
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
        const unsigned char *one = a->pixel + 3 * i, *other = b->pixel + 3 * i;
        bool same = true;
        for (int k = 0; k < 3; k++)
            same = same && abs(one[k] - other[k]) <= 2;
        count += !same;
    }
    return count;
}

// Draw a chapter, then draw it again with four times as many steps, and return how many pixels
// differ: those whose rays ran out of steps.
static int unfinished(const char *stem)
{
    struct camera camera = gpu_open_chapter(stem);
    struct parameter *steps = parameters_find(&gpu.renderer.parameters, "maxSteps");
    if (steps == NULL) // chapter 00 has a limit that is not a parameter
        return 0;
    struct image image = drawn(&camera);
    gpu_set("maxSteps", 4.0 * steps->value[0]);
    struct image longer = drawn(&camera);
    int count = different(&image, &longer);
    image_free(&image);
    image_free(&longer);
    return count;
}

TEST(test_no_ray_of_a_chapter_runs_out_of_steps)
{
    glob_t found;
    int failed = 0;
    assert_int_equal(glob("chapters/[0-9][0-9]_*.frag", 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        char stem[64];
        snprintf(stem, sizeof stem, "%s", found.gl_pathv[i] + strlen("chapters/"));
        *strchr(stem, '.') = '\0';
        int count = unfinished(stem);
        printf("# drawn: %s, unfinished pixels: %d\n", stem, count);
        fflush(stdout);
        failed += count > 5;
    }
    assert_true(found.gl_pathc >= 24);
    globfree(&found);
    assert_int_equal(failed, 0);
}

TESTS(gpu_setup, gpu_teardown)
