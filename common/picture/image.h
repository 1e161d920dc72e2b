// image.h - 8-bit RGB pictures, written as PNG.
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>

// A picture in memory. Row 0 is the top row; a pixel is 3 bytes: red, green, blue.
struct image {
    int width, height;    // pixels, at least 1 each
    unsigned char *pixel; // 3 * width * height bytes, owned by this struct
};

// Allocate a black picture. Returns false, reported, when memory is short. Free it with image_free.
bool image_create(struct image *image, int width, int height);

// Free the pixels; an image of zeros is allowed.
void image_free(struct image *image);

// Store rows of colours as bytes: a channel v becomes floor(255 clamp(v, 0, 1) + 0.5), a NaN 0.
//   values  4 floats a pixel, the last of which counts for nothing; image->width x rows of them,
//   the
//           lowest row first
//   bottom  the first of these rows in the picture, counted from its lowest
void image_store(struct image *image, const float *values, int bottom, int rows);

// Write a PNG (8-bit RGB, sRGB chunk, fast compression).
//   path  written beside and renamed over, so that a reader never sees half a file; symbolic links
//         are followed; an existing target that is not a regular file is refused
// Returns false, reported, when it cannot; then nothing is left behind and the old file stands.
bool image_write_png(const struct image *image, const char *path);

// Say whether image_write_png could write there, before the work of rendering: refuses a missing
// folder, a target that is not a regular file, a folder that cannot be written. Reported.
bool image_check_target(const char *path);

#endif
