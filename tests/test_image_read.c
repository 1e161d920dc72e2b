// Unit tests of tests/support_compare.c: what image_read_png takes, and what it refuses.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>

#include <png.h>

#include "support_compare.h"
#include "support_image.h"
#include "support_scratch.h"

static void write_bytes(const char *path, const unsigned char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

static void what_is_no_png_is_refused(void **state)
{
    const struct picture_folder *in = *state;
    struct image image;
    capture_begin();
    assert_true(picture_refused(image_read_png(&image, in->target), "No such file"));
    write_bytes(in->target, (const unsigned char *)"", 0);
    capture_begin();
    assert_true(picture_refused(image_read_png(&image, in->target), "cannot be read"));
    write_bytes(in->target, (const unsigned char *)"P6 1 1 255 and more text", 24);
    capture_begin();
    assert_true(picture_refused(image_read_png(&image, in->target), "Not a PNG file"));
    capture_begin();
    assert_true(picture_refused(image_read_png(&image, in->folder), "not a regular file"));
    assert_null(image.pixel);
}

static void every_truncated_file_is_refused(void **state)
{
    const struct picture_folder *in = *state;
    unsigned char bytes[2048];
    struct image image = picture_random(9, 9), read;
    assert_true(image_write_png(&image, in->target));
    size_t size = picture_bytes(in->target, bytes, sizeof bytes);
    assert_true(size > 200 && size < sizeof bytes);
    for (size_t i = 0; i < size; i++) {
        write_bytes(in->target, bytes, i);
        capture_begin();
        assert_true(picture_refused(image_read_png(&read, in->target), "cannot be read"));
        assert_null(read.pixel);
    }
    image_free(&image);
}

// A changed byte may escape (in a name of a chunk that is skipped, say), but the picture may not
// change.
static void every_changed_byte_is_harmless(void **state)
{
    const struct picture_folder *in = *state;
    unsigned char bytes[2048];
    struct image image = picture_random(9, 9), read;
    assert_true(image_write_png(&image, in->target));
    size_t size = picture_bytes(in->target, bytes, sizeof bytes), caught = 0;
    for (size_t i = 0; i < size; i++) {
        bytes[i] ^= 0x55;
        write_bytes(in->target, bytes, size);
        bytes[i] ^= 0x55;
        capture_begin();
        bool done = image_read_png(&read, in->target);
        capture_end();
        caught += !done;
        if (done)
            assert_memory_equal(read.pixel, image.pixel, 3 * 9 * 9);
        image_free(&read);
    }
    assert_true(caught > size * 9 / 10);
    image_free(&image);
}

static void write_kind(const struct picture_folder *in, png_uint_32 format, int width, int height,
                       const void *pixels, const void *colours, png_uint_32 colour_count)
{
    png_image kind = {.version = PNG_IMAGE_VERSION,
                      .width = (png_uint_32)width,
                      .height = (png_uint_32)height,
                      .format = format,
                      .colormap_entries = colour_count};
    assert_true(png_image_write_to_file(&kind, in->target, 0, pixels, 0, colours));
}

static void every_kind_of_png_becomes_rgb(void **state)
{
    const struct picture_folder *in = *state;
    static const unsigned char with_alpha[] = {1, 2, 3, 128, 200, 100, 50, 0};
    static const unsigned char grey[] = {7, 250}, numbers[] = {1, 0};
    static const unsigned char colours[] = {9, 8, 7, 60, 50, 40};
    static const uint16_t deep[] = {0, 65535, 0, 65535, 0, 65535};
    static const unsigned char expected[][6] = {{1, 2, 3, 200, 100, 50},
                                                {7, 7, 7, 250, 250, 250},
                                                {60, 50, 40, 9, 8, 7},
                                                {0, 255, 0, 255, 0, 255}};
    for (int i = 0; i < 4; i++) {
        struct image image;
        if (i == 0)
            write_kind(in, PNG_FORMAT_RGBA, 2, 1, with_alpha, NULL, 0);
        else if (i == 1)
            write_kind(in, PNG_FORMAT_GRAY, 2, 1, grey, NULL, 0);
        else if (i == 2)
            write_kind(in, PNG_FORMAT_RGB_COLORMAP, 2, 1, numbers, colours, 2);
        else
            write_kind(in, PNG_FORMAT_FLAG_LINEAR | PNG_FORMAT_FLAG_COLOR, 2, 1, deep, NULL, 0);
        assert_true(image_read_png(&image, in->target));
        assert_memory_equal(image.pixel, expected[i], 6);
        image_free(&image);
    }
}

static void pictures_too_large_are_refused(void **state)
{
    const struct picture_folder *in = *state;
    struct image image;
    unsigned char *row = calloc(16385, 1);
    assert_non_null(row);
    write_kind(in, PNG_FORMAT_GRAY, 16385, 1, row, NULL, 0);
    free(row);
    capture_begin();
    assert_true(picture_refused(image_read_png(&image, in->target), "longer than 16384"));
    assert_null(image.pixel);
}

#define IN_FOLDER(name)                                                                            \
    cmocka_unit_test_setup_teardown(name, picture_folder_make, picture_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(what_is_no_png_is_refused),      IN_FOLDER(every_truncated_file_is_refused),
        IN_FOLDER(every_changed_byte_is_harmless), IN_FOLDER(every_kind_of_png_becomes_rgb),
        IN_FOLDER(pictures_too_large_are_refused),
    };
    return cmocka_run_group_tests_name("image_read", tests, NULL, NULL);
}
