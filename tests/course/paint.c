// paint.c - tests the functions of shaders/textures/paint.c, with which the textures are drawn, and
// checks that the pictures repeat without a seam. tests/course/textures.sh compares the pictures
// with the output of their programs.
#include "lib/test.h"

#include <dirent.h>

#include "textures/paint.h"
#include "textures/weave.h"
#include "lib/compare.h"

#define FOLDER "shaders/textures"

// ---- Chance ----

// Each flipped input bit flips each output bit in about half of the cases. The count over 1024
// cases has a standard deviation of 16, and all 32 x 96 counts stay within five standard
// deviations.
TEST(every_bit_matters)
{
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

// The mean of n numbers uniformly distributed in [0, 1) is 1/2, with a standard deviation of
// 1/sqrt(12 n); the test allows four standard deviations.
TEST(random_numbers_have_the_right_mean)
{
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

// A random multiple of 2^-20 in [0, 1). A double represents it exactly, and also the coordinates
// one period away.
static double coordinate(int i, uint32_t seed)
{
    return (double)(paint_hash(i, 0, seed) >> 12) / 1048576.0;
}

TEST(patterns_have_the_period_1)
{
    for (int i = 0; i < 2000; i++) {
        double u = coordinate(i, 1), v = coordinate(i, 2);
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

// ---- The pictures ----

// The number of slices if the picture is a volume, whose square slices are one below the other. Any
// other picture has one slice.
static int slices_of(const struct image *image)
{
    return image->height > image->width && image->height % image->width == 0
               ? image->height / image->width
               : 1;
}

// The mean difference between two neighbouring layers of a volume: the layer `at` and the next one.
// The last layer is followed by the first.
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

// True if the step from the last layer to the first is no larger than the largest other step.
static bool repeats(const struct image *image, int axis)
{
    int slices = slices_of(image), size[3] = {image->width, image->height / slices, slices};
    double largest = 0.0;
    for (int at = 0; at < size[axis] - 1; at++)
        largest = fmax(largest, step_across(image, axis, at));
    return size[axis] == 1 || step_across(image, axis, size[axis] - 1) <= largest;
}

// The left part of a picture, of the given width.
static struct image cropped(const struct image *image, int width)
{
    struct image part;
    assert_true(image_create(&part, width, image->height));
    for (int y = 0; y < image->height; y++)
        memcpy(part.pixel + 3 * width * y, image->pixel + 3 * image->width * y, 3 * (size_t)width);
    return part;
}

// Assert that a PNG has 8 bits per channel, is grey, RGB or RGBA, and is not interlaced. Every PNG
// reader supports such a file.
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

// True if a picture is a table that does not repeat: the first comment of its program says that the
// table is read with clamp, or as the whole numbers of a usampler2D.
static bool is_clamped(const char *path)
{
    char source[256], line[256];
    snprintf(source, sizeof source, "%.*s.c", (int)(strlen(path) - strlen(".png")), path);
    FILE *file = fopen(source, "r");
    assert_non_null(file);
    bool clamped = false;
    while (fgets(line, sizeof line, file) != NULL && strncmp(line, "//", 2) == 0)
        clamped = clamped || strstr(line, " clamp") != NULL || strstr(line, "usampler2D") != NULL;
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
            fail_msg("%s has a seam across axis %d", path, axis);
    // A picture that does not repeat must be detected.
    struct image part = cropped(&image, image.width - image.width / 10);
    if (slices_of(&image) == 1 && repeats(&part, 0))
        fail_msg("%s: no seam is detected after a tenth of the width is cut off", path);
    image_free(&part);
    image_free(&image);
}

TEST(pictures_repeat_without_a_seam)
{
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

TESTS(NULL, NULL)
