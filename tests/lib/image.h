// image.h - for the tests of pictures: pictures to test with, a folder for them, and what a
// refusal must look like.
#ifndef TESTS_IMAGE_H
#define TESTS_IMAGE_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

#include "picture/image.h"
#include "lib/compare.h"

// A folder of one test alone, and paths in it where nothing is yet.
struct picture_folder {
    char folder[PATH_MAX];
    char target[PATH_MAX + 16], link[PATH_MAX + 16], other[PATH_MAX + 16];
};

// Setup and teardown of cmocka; *state is the struct picture_folder in between.
int picture_folder_make(void **state);
int picture_folder_remove(void **state);

// The number of entries in the folder.
int picture_folder_count(const struct picture_folder *in);

// After capture_begin: true when a call failed and reported one line that holds a text.
bool picture_refused(bool done, const char *text);

// Pictures to test with, the same in every run; freed by the caller. Of random pixels; of pixels
// that differ from their neighbours by a little; equal to another.
struct image picture_random(int width, int height);
struct image picture_smooth(int width, int height);
struct image picture_copy(const struct image *image);

// Read a file's bytes, at most size of them. Returns how many; fails the test where it is missing.
size_t picture_bytes(const char *path, unsigned char *bytes, size_t size);

// Fails the test unless the file holds exactly this picture.
void picture_assert_stored(const char *path, const struct image *expected);

#endif
