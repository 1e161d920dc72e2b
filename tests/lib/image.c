#include "lib/image.h"

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

#include "lib/scratch.h"

int picture_folder_make(void **state)
{
    struct picture_folder *in = malloc(sizeof *in);
    if (in == NULL)
        return -1;
    snprintf(in->folder, sizeof in->folder, "%s", scratch_make());
    snprintf(in->target, sizeof in->target, "%s/picture.png", in->folder);
    snprintf(in->link, sizeof in->link, "%s/link.png", in->folder);
    snprintf(in->other, sizeof in->other, "%s/other.png", in->folder);
    *state = in;
    return 0;
}

int picture_folder_remove(void **state)
{
    free(*state);
    scratch_remove();
    return 0;
}

int picture_folder_count(const struct picture_folder *in)
{
    int count = 0;
    DIR *directory = opendir(in->folder);
    assert_non_null(directory);
    for (const struct dirent *entry; (entry = readdir(directory)) != NULL;)
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    closedir(directory);
    return count;
}

bool picture_refused(bool done, const char *text)
{
    const char *heard = capture_end();
    if (!done && line_count(heard) == 1 && strstr(heard, text) != NULL)
        return true;
    print_message("# expected a refusal with '%s', got '%.500s'\n", text, heard);
    return false;
}

struct image picture_random(int width, int height)
{
    struct image image;
    uint32_t random = 12345;
    assert_true(image_create(&image, width, height));
    for (size_t i = 0; i < 3 * (size_t)width * (size_t)height; i++) {
        random = random * 1664525u + 1013904223u;
        image.pixel[i] = (unsigned char)(random >> 24);
    }
    return image;
}

struct image picture_smooth(int width, int height)
{
    struct image image;
    assert_true(image_create(&image, width, height));
    for (int i = 0; i < width * height; i++)
        for (int c = 0; c < 3; c++)
            image.pixel[3 * i + c] = (unsigned char)(120.0 + 60.0 * sin(0.11 * (i % width) + c) +
                                                     50.0 * cos(0.07 * (i / width)));
    return image;
}

struct image picture_copy(const struct image *image)
{
    struct image copy;
    assert_true(image_create(&copy, image->width, image->height));
    memcpy(copy.pixel, image->pixel, 3 * (size_t)image->width * (size_t)image->height);
    return copy;
}

size_t picture_bytes(const char *path, unsigned char *bytes, size_t size)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t length = fread(bytes, 1, size, file);
    fclose(file);
    return length;
}

void picture_assert_stored(const char *path, const struct image *expected)
{
    struct image image;
    assert_true(image_read_png(&image, path));
    assert_int_equal(image.width, expected->width);
    assert_int_equal(image.height, expected->height);
    assert_memory_equal(image.pixel, expected->pixel,
                        3 * (size_t)image.width * (size_t)image.height);
    image_free(&image);
}
