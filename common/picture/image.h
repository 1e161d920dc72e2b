// image.h - 8-bit RGB pictures: PNG in and out, and the comparison of two pictures.
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>
#include <stddef.h>

// A picture in memory. Row 0 is the top row; a pixel is 3 bytes: red, green, blue.
struct image {
    int width, height;    // pixels, at least 1 each
    unsigned char *pixel; // 3 * width * height bytes, owned by this struct
};

// Two numbers that decide together whether two pictures are the same one.
struct image_difference {
    double f2;      // share of pixels whose largest channel difference exceeds 2, in [0, 1]
    double b8;      // RMSE of the means of 8x8 blocks, on the worst channel, in [0, 255]
    int largest;    // largest channel difference, for information: silhouettes make it useless
    size_t differs; // pixels that differ at all
    int x, y;       // middle of the 8x8 block that differs most, pixels, 0,0 bottom left
};

#define IMAGE_F2_TOLERANCE 0.0005 // 0.05 % of the pixels
#define IMAGE_B8_TOLERANCE 0.15

// Allocate a black picture. Returns false, reported, when memory is short. Free it with image_free.
bool image_create(struct image *image, int width, int height);

// Free the pixels; an image of zeros is allowed.
void image_free(struct image *image);

// Write a PNG (8-bit RGB, sRGB chunk, fast compression).
//   path  written beside and renamed over, so that a reader never sees half a file; symbolic links
//         are followed; an existing target that is not a regular file is refused
// Returns false, reported, when it cannot; then nothing is left behind and the old file stands.
bool image_write_png(const struct image *image, const char *path);

// Say whether image_write_png could write there, before the work of rendering: refuses a missing
// folder, a target that is not a regular file, a folder that cannot be written. Reported.
bool image_check_target(const char *path);

// Read any PNG as 8-bit RGB (transparency is dropped). Returns false, reported; free with
// image_free.
bool image_read_png(struct image *image, const char *path);

// Compare two pictures. Returns false, reported, when their sizes differ.
// Blocks at the right and bottom edges are smaller where 8 does not divide the size.
bool image_compare(const struct image *a, const struct image *b, struct image_difference *result);

// True when f2 and b8 are both within tolerance.
bool image_same(const struct image_difference *difference);

// A picture of the difference: 128 + 4 (b - a) per channel, clamped. Same sizes required; the
// caller frees result. Returns false, reported.
bool image_difference_picture(const struct image *a, const struct image *b, struct image *result);

#endif
