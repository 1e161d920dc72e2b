// image_read.c - tests that every kind of PNG is read, and that a file is refused if it is not a
// PNG, is broken or is too large.
#include "lib/test.h"
#include "picture/image.h"
#include "lib/image.h"
#include "lib/png.h"
#include "lib/scratch.h"
#include "lib/system.h"

#define PIXELS (16384 * 1024) // most pixels that a picture may have

// ---- Every kind of PNG ----

static void check_kind(const struct png_kind *kind)
{
    enum { WIDTH = 11, HEIGHT = 9 };
    uint16_t sample[4 * WIDTH * HEIGHT];
    char why[IMAGE_WHY] = "";
    struct image_bytes bytes;
    int channels = png_channels(kind->type);
    unsigned limit =
        kind->type == PNG_COLOR_TYPE_PALETTE && kind->depth == 8 ? 16 : 1u << kind->depth;
    for (int i = 0; i < channels * WIDTH * HEIGHT; i++)
        sample[i] = (uint16_t)(png_random(3) == 0 ? png_random(4) % limit : png_random(limit));
    sample[0] = sample[1] = sample[2] = channels == 1 ? 1 : 3; // transparent if the file has tRNS
    const char *path = png_file("kind.png", kind, WIDTH, HEIGHT, sample);
    for (int wanted = 3; wanted <= 4; wanted++) {
        if (!image_read_bytes(&bytes, path, wanted, 1000, why))
            fail_msg("type %d, %d bits: %s", kind->type, kind->depth, why);
        assert_true(bytes.width == WIDTH && bytes.height == HEIGHT && bytes.channels == wanted);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            unsigned char texel[4];
            png_texel(kind, sample + channels * i, texel);
            if (memcmp(texel, bytes.value + wanted * i, (size_t)wanted) != 0)
                fail_msg("type %d, %d bits, transparent %d: texel %d is wrong", kind->type,
                         kind->depth, kind->transparent, i);
        }
        free(bytes.value);
    }
}

TEST(every_kind_of_png_is_read)
{
    static const int kinds[][2] = {{PNG_COLOR_TYPE_GRAY, 1},       {PNG_COLOR_TYPE_GRAY, 2},
                                   {PNG_COLOR_TYPE_GRAY, 4},       {PNG_COLOR_TYPE_GRAY, 8},
                                   {PNG_COLOR_TYPE_GRAY, 16},      {PNG_COLOR_TYPE_PALETTE, 1},
                                   {PNG_COLOR_TYPE_PALETTE, 2},    {PNG_COLOR_TYPE_PALETTE, 4},
                                   {PNG_COLOR_TYPE_PALETTE, 8},    {PNG_COLOR_TYPE_RGB, 8},
                                   {PNG_COLOR_TYPE_RGB, 16},       {PNG_COLOR_TYPE_RGB_ALPHA, 8},
                                   {PNG_COLOR_TYPE_RGB_ALPHA, 16}, {PNG_COLOR_TYPE_GRAY_ALPHA, 8},
                                   {PNG_COLOR_TYPE_GRAY_ALPHA, 16}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (int option = 0; option < 8; option++) {
            struct png_kind kind = {.type = kinds[i][0],
                                    .depth = kinds[i][1],
                                    .interlaced = option % 2 == 1,
                                    .transparent = option / 2 % 2 == 1,
                                    .gamma = option / 4 == 1 ? 1.0 : 0.0};
            if (!kind.transparent || png_channels(kind.type) % 2 == 1)
                check_kind(&kind);
        }
}

// ---- Files that are refused ----

static void assert_refused(const char *name, const char *expected)
{
    char why[IMAGE_WHY] = "";
    struct image_bytes bytes;
    if (image_read_bytes(&bytes, scratch_path(name), 4, PIXELS, why))
        fail_msg("%s is accepted", name);
    assert_null(bytes.value);
    if (strstr(why, expected) == NULL)
        fail_msg("%s: '%s', not '%s'", name, why, expected);
}

TEST(a_file_that_is_not_a_picture_is_refused)
{
    assert_refused("none.png", "No such file");
    scratch_write_bytes("empty.png", (const unsigned char *)"", 0);
    assert_refused("empty.png", "cannot be read");
    scratch_write_bytes("text.png", (const unsigned char *)"P6 1 1 255 and more text", 24);
    assert_refused("text.png", "cannot be read: Not a PNG file: save it again as a PNG");
    assert_true(system_make_folder(scratch_path("folder.png")));
    assert_refused("folder.png", "not a regular file");
    if (system_make_pipe(scratch_path("fifo.png")))
        assert_refused("fifo.png", "not a regular file");
}

// Each prefix of a file is refused, and so is a file with one byte changed, except in the last four
// bytes. These are the checksum of the empty chunk that ends the file, which libpng 1.6.48 no
// longer checks.
TEST(broken_pictures_are_refused)
{
    unsigned char bytes[4096];
    const char *path = png_file_random("whole.png", 7, 5, NULL);
    size_t size = picture_bytes(path, bytes, sizeof bytes);
    for (size_t i = 0; i < size; i++) {
        scratch_write_bytes("part.png", bytes, i);
        assert_refused("part.png", "cannot be read");
    }
    for (size_t i = 0; i < size - 4; i++) {
        bytes[i] ^= 0x11;
        scratch_write_bytes("part.png", bytes, size);
        bytes[i] ^= 0x11;
        assert_refused("part.png", ""); // the reason depends on the byte
    }
}

TEST(sizes_have_their_limits)
{
    const struct png_kind kind = {.type = PNG_COLOR_TYPE_GRAY, .depth = 1};
    uint16_t *sample = calloc(16385 * 1025, sizeof *sample);
    assert_non_null(sample);
    png_file("long.png", &kind, 16385, 1, sample);
    assert_refused("long.png", "longer than 16384 pixels: make the picture smaller");
    png_file("large.png", &kind, 16384, 1025, sample);
    assert_refused("large.png", "too many pixels");
    // Patch a width of 0 and its checksum into a file, because libpng refuses to write this width.
    unsigned char bytes[4096];
    const char *path = png_file("none.png", &kind, 4, 12, sample);
    size_t size = picture_bytes(path, bytes, sizeof bytes);
    free(sample);
    static const unsigned char none[] = {0, 0, 0, 0, 0,    0,    0,    12,  1,
                                         0, 0, 0, 0, 0x64, 0x32, 0x81, 0xC4};
    memcpy(bytes + 16, none, sizeof none);
    scratch_write_bytes("zero.png", bytes, size);
    assert_refused("zero.png", "Invalid IHDR");
}

// ---- Open files ----

TEST(reading_leaves_no_file_open)
{
    char why[IMAGE_WHY];
    struct image_bytes bytes;
    const char *path = png_file_random("open.png", 7, 5, NULL);
    scratch_write("broken.png", "no picture");
    int before = system_open_files();
    for (int i = 0; i < 50; i++) {
        assert_true(image_read_bytes(&bytes, path, 4, PIXELS, why));
        free(bytes.value);
    }
    assert_int_equal(system_open_files(), before);
    for (int i = 0; i < 50; i++) {
        assert_refused("broken.png", "cannot be read");
        assert_refused("missing.png", "No such file");
    }
    assert_int_equal(system_open_files(), before);
}

TESTS(scratch_setup, scratch_teardown)
