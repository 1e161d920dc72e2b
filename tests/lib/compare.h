// compare.h - reads pictures, and compares two of them.
#ifndef TESTS_COMPARE_H
#define TESTS_COMPARE_H

#include <stdbool.h>
#include <stddef.h>

#include "picture/image.h"

// How two pictures differ: f2 and b8 together decide whether the pictures count as the same.
struct image_difference {
    double f2;      // share of pixels whose largest channel difference exceeds 2, in [0, 1]
    double b8;      // RMSE of the means of 8x8 blocks, on the worst channel, in [0, 255]
    int largest;    // largest channel difference, for information only: it is large at silhouettes
    size_t differs; // pixels that differ at all
    int x, y; // the pixel that differs most in the 8x8 block that does; 0,0 is at the bottom left
};

#define IMAGE_F2_TOLERANCE 0.0005 // 0.05 % of the pixels
#define IMAGE_B8_TOLERANCE 0.15

// Read any PNG as 8-bit RGB (transparency is dropped). Returns false after reporting the error.
// Free the picture with image_free.
bool image_read_png(struct image *image, const char *path);

// Compare two pictures. Reports an error and returns false if their sizes differ. Blocks at the
// right and bottom edges are smaller if the size is not a multiple of 8.
bool image_compare(const struct image *a, const struct image *b, struct image_difference *result);

// True if f2 and b8 are both within tolerance.
bool image_same(const struct image_difference *difference);

// Describe the difference in a sentence for a student. Returns words.
const char *image_difference_words(const struct image_difference *difference, char words[256]);

// Print the numbers of a difference on one line.
void image_print_difference(const struct image_difference *difference);

// Make a picture of the difference: 128 + 4 (b - a) per channel, clamped. The two sizes must be the
// same. The caller frees result. Returns false after reporting the error.
bool image_difference_picture(const struct image *a, const struct image *b, struct image *result);

#endif
