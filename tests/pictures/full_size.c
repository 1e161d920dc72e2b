// full_size.c - tests every chapter's picture at 1920x1080, the size of most screens: no ray runs
// out of steps, and the picture has as much light as a small one.
#include <glob.h>

#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

enum {
    MOST = 64,
    WIDTH = 1920,
    HEIGHT = 1080,
    SMALL = 6
}; // SMALL: how much smaller the small picture is

// What was measured of a chapter.
struct chapter_result {
    char stem[64];
    int unfinished; // pixels whose rays ran out of steps
    double excess;  // light of the large picture divided by that of the small one, minus 1
};

static struct chapter_result result[MOST];
static size_t count;

static struct image drawn(const struct camera *camera, int smaller)
{
    struct renderer_inputs inputs = {
        .width = WIDTH / smaller, .height = HEIGHT / smaller, .samples = 1, .camera = *camera};
    struct image image = {0};
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    return image;
}

// The number of pixels of which a channel differs by more than 2 of 255.
static int different(const struct image *a, const struct image *b)
{
    int differing = 0;
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
        const unsigned char *one = a->pixel + 3 * i, *other = b->pixel + 3 * i;
        bool same = true;
        for (int k = 0; k < 3; k++)
            same = same && abs(one[k] - other[k]) <= 2;
        differing += !same;
    }
    return differing;
}

// The mean of all channels of all pixels, as light.
static double mean_light(const struct image *image)
{
    size_t number[256] = {0}, channels = 3 * (size_t)image->width * (size_t)image->height;
    double sum = 0.0;
    for (size_t i = 0; i < channels; i++)
        number[image->pixel[i]]++;
    for (int i = 0; i < 256; i++)
        sum += (double)number[i] * mirror_decode(i / 255.0);
    return sum / (double)channels;
}

// Set the parameters with which the light of a chapter is measured; return false if they are the
// default ones. The holes in the pyramid of chapter 06 have all sizes, so a ray as wide as a pixel
// closes more of them in a small picture; the page says so. The colours of chapter 16 count steps,
// and are no light.
static bool show_light(const char *stem)
{
    bool pyramid = strcmp(stem, "06_sierpinski_symmetry") == 0;
    bool steps = strcmp(stem, "16_fewer_steps") == 0;
    if (pyramid)
        gpu_set("footprint", 0.0);
    if (steps)
        gpu_set("lit", 1.0);
    return pyramid || steps;
}

static void measure(struct chapter_result *chapter)
{
    struct camera camera = gpu_open_chapter(chapter->stem);
    struct image large = drawn(&camera, 1);
    struct parameter *steps = parameters_find(&gpu.renderer.parameters, "maxSteps");
    if (steps != NULL) { // the limit of chapter 00 is not a parameter
        double most = steps->value[0];
        gpu_set("maxSteps", 4.0 * most);
        struct image longer = drawn(&camera, 1);
        chapter->unfinished = different(&large, &longer);
        gpu_set("maxSteps", most);
        image_free(&longer);
    }
    if (show_light(chapter->stem)) {
        image_free(&large);
        large = drawn(&camera, 1);
    }
    struct image small = drawn(&camera, SMALL);
    chapter->excess = mean_light(&large) / mean_light(&small) - 1.0;
    image_free(&large);
    image_free(&small);
}

static int measure_all(void **state)
{
    glob_t found;
    if (gpu_setup(state) != 0 || glob("chapters/[0-9][0-9]_*.frag", 0, NULL, &found) != 0)
        return -1;
    for (; count < found.gl_pathc && count < MOST; count++) {
        struct chapter_result *chapter = &result[count];
        snprintf(chapter->stem, sizeof chapter->stem, "%s",
                 found.gl_pathv[count] + strlen("chapters/"));
        *strchr(chapter->stem, '.') = '\0';
        measure(chapter);
        printf("# drawn: %s, unfinished pixels: %d, light: %+.2f %%\n", chapter->stem,
               chapter->unfinished, 100.0 * chapter->excess);
        fflush(stdout);
    }
    globfree(&found);
    return count >= 24 ? 0 : -1;
}

TEST(test_no_ray_runs_out_of_steps)
{
    for (size_t i = 0; i < count; i++)
        assert_in_range(result[i].unfinished, 0, 5);
}

// A shadow that starts nearer to the surface in a finer picture, or an outline that grows by the
// width of a pixel, changes the light of the whole picture.
TEST(test_a_large_picture_is_as_bright_as_a_small_one)
{
    for (size_t i = 0; i < count; i++)
        assert_true(fabs(result[i].excess) < 0.01);
}

TESTS(measure_all, gpu_teardown)
