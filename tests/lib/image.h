// image.h - for the tests of pictures: sample pictures, a folder for them, and a check that a call
// was refused.
#ifndef TESTS_IMAGE_H
#define TESTS_IMAGE_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

#include "picture/image.h"
#include "lib/compare.h"

// A folder for one test, and paths in it at which there is no file yet.
struct picture_folder {
    char folder[PATH_MAX];
    char target[PATH_MAX + 16], link[PATH_MAX + 16], other[PATH_MAX + 16];
};

// cmocka's setup and teardown; between them, *state points to the struct picture_folder.
int picture_folder_make(void **state);
int picture_folder_remove(void **state);

// The number of entries in the folder.
int picture_folder_count(const struct picture_folder *in);

// End a capture: true if the call since capture_begin failed and reported one line that contains
// the text.
//   done  the call's result
bool picture_refused(bool done, const char *text);

// Sample pictures, the same in every run; the caller frees them. One has random pixels, one has
// pixels that differ a little from their neighbours, and one is a copy of another picture.
struct image picture_random(int width, int height);
struct image picture_smooth(int width, int height);
struct image picture_copy(const struct image *image);

// Read at most size bytes of a file. Returns the number of bytes read; fails the test if the file
// is missing.
size_t picture_bytes(const char *path, unsigned char *bytes, size_t size);

// Fails the test unless the file contains exactly this picture.
void picture_assert_stored(const char *path, const struct image *expected);

#endif
