// texture_image.c - tests the pictures that shaders read, before the driver receives them: the
// order of the slices, and the mip levels, which are compared with means in double precision.
#include "lib/test.h"
#include "picture/texture.h"
#include "lib/mirror.h"
#include "lib/png.h"
#include "lib/scratch.h"
#include "lib/system.h"

// ---- Pictures that are refused ----

static void assert_refused(const char *name, int slices, const char *expected)
{
    char why[IMAGE_WHY] = "";
    struct texture_image image;
    const struct sampler sampler = {.srgb = true, .slices = slices};
    if (texture_image_read(&image, &sampler, scratch_path(name), why))
        fail_msg("%s is accepted", name);
    assert_int_equal(image.count, 0);
    if (strstr(why, expected) == NULL)
        fail_msg("%s: '%s', not '%s'", name, why, expected);
}

TEST(a_picture_that_cannot_be_a_texture_is_refused)
{
    const struct png_kind kind = {.type = PNG_COLOR_TYPE_GRAY, .depth = 1};
    uint16_t *sample = calloc(16384 * 1025, sizeof *sample);
    assert_non_null(sample);
    png_file("large.png", &kind, 16384, 1025, sample);
    png_file("volume.png", &kind, 4, 12, sample);
    free(sample);
    assert_refused("none.png", 0, "No such file");
    assert_refused("large.png", 0, "too many pixels");
    assert_refused("volume.png", 5, "5 slices do not divide the height of 12 pixels");
    assert_refused("volume.png", 24, "24 slices do not divide");
}

TEST(a_texture_leaves_no_file_open)
{
    struct texture_image image;
    const struct sampler sampler = {.srgb = true};
    const char *path = png_file_random("open.png", 4, 12, NULL);
    int before = system_open_files();
    for (int i = 0; i < 50; i++) {
        char why[IMAGE_WHY] = "";
        assert_true(texture_image_read(&image, &sampler, path, why));
        texture_image_free(&image);
        assert_refused("open.png", 5, "5 slices do not divide");
    }
    assert_int_equal(system_open_files(), before);
}

// ---- Levels ----

// The length of the overlap of cell a of n with cell b of m, where each row of cells fills [0, 1].
static double common_part(int a, int n, int b, int m)
{
    double begin = fmax((double)a / n, (double)b / m);
    double end = fmin((a + 1.0) / n, (b + 1.0) / m);
    return fmax(end - begin, 0.0);
}

// The mean of a level's texels over a texel of the next level. The weight of a texel is the volume
// of its overlap with the texel of the next level.
//   n, m  sizes of the level and of the next level
//   at    the texel of the next level
static double mean_over(const double *value, const int n[3], const int m[3], const int at[3],
                        int channel)
{
    double sum = 0.0, all = 0.0;
    for (int z = 0; z < n[2]; z++)
        for (int y = 0; y < n[1]; y++)
            for (int x = 0; x < n[0]; x++) {
                double part = common_part(x, n[0], at[0], m[0]) *
                              common_part(y, n[1], at[1], m[1]) * common_part(z, n[2], at[2], m[2]);
                sum += part * value[4 * ((z * n[1] + y) * n[0] + x) + channel];
                all += part;
            }
    return sum / all;
}

static void check_level(const struct texture_image *image, int level, const double *value,
                        bool srgb)
{
    const int *size = image->size[level];
    for (int i = 0; i < 4 * size[0] * size[1] * size[2]; i++) {
        double wanted = 255.0 * (srgb && i % 4 < 3 ? mirror_encode(value[i]) : value[i]);
        // Rounding to a byte causes an error of at most 0.5, and single precision adds a little.
        if (fabs(wanted - image->level[level][i]) > 0.5 + 1e-3)
            fail_msg("level %d, value %d is %d, not %f", level, i, image->level[level][i], wanted);
    }
}

static void check_levels(const int size[3], bool srgb)
{
    enum { MOST = 4 * 4096 };
    static double value[2][MOST];
    static unsigned char texel[MOST];
    int width = size[0], height = size[1] * size[2], level = 0;
    struct texture_image image;
    char why[IMAGE_WHY] = "";
    const struct sampler sampler = {.srgb = srgb, .slices = size[2]};
    if (!texture_image_read(&image, &sampler, png_file_random("levels.png", width, height, texel),
                            why))
        fail_msg("%s", why);
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            for (int i = 0; i < 4 * width; i++) {
                // The first slice is at the top of the file. A texture has the bottom row of each
                // slice first.
                int row = z * size[1] + size[1] - 1 - y;
                double v = texel[4 * width * row + i] / 255.0;
                value[0][4 * width * (z * size[1] + y) + i] =
                    srgb && i % 4 < 3 ? mirror_decode(v) : v;
            }
    assert_memory_equal(image.size[0], size, sizeof image.size[0]);
    check_level(&image, 0, value[0], srgb);
    for (int n[3] = {size[0], size[1], size[2]}; n[0] * n[1] * n[2] > 1; level++) {
        int m[3], at[3];
        for (int i = 0; i < 3; i++)
            m[i] = n[i] > 1 ? n[i] / 2 : 1;
        double *to = value[(level + 1) % 2];
        for (at[2] = 0; at[2] < m[2]; at[2]++)
            for (at[1] = 0; at[1] < m[1]; at[1]++)
                for (at[0] = 0; at[0] < m[0]; at[0]++)
                    for (int c = 0; c < 4; c++)
                        to[4 * ((at[2] * m[1] + at[1]) * m[0] + at[0]) + c] =
                            mean_over(value[level % 2], n, m, at, c);
        assert_true(level + 1 < image.count);
        assert_memory_equal(image.size[level + 1], m, sizeof m);
        check_level(&image, level + 1, to, srgb);
        memcpy(n, m, sizeof m);
    }
    assert_int_equal(image.count, level + 1);
    texture_image_free(&image);
}

TEST(levels_are_means_in_linear_light)
{
    static const int sizes[][3] = {{16, 16, 1}, {1, 1, 1}, {5, 3, 1}, {13, 1, 1}, {1, 6, 1},
                                   {8, 4, 4},   {5, 3, 7}, {1, 1, 9}, {3, 5, 2},  {30, 17, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int srgb = 0; srgb < 2; srgb++)
            check_levels(sizes[i], srgb == 1);
}

TESTS(scratch_setup, scratch_teardown)
