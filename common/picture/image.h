// image.h - 8-bit pictures: RGB in memory, written as PNG; any PNG, read.
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>
#include <stddef.h>

#define IMAGE_SIDE_LIMIT 16384 // pixels
#define IMAGE_WHY        512   // size of the phrase, bytes

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

// What a PNG holds.
struct image_bytes {
    int width, height, channels;
    unsigned char *value; // row 0 is the top row; freed by the caller
};

// Read a PNG of any kind, interlaced too, as 8 bits a channel: grey becomes red, green and blue
// alike, a palette its colours, 16 bits are rounded, tRNS becomes alpha. The values are those that
// are stored: a gamma that the file names is not applied.
//   channels  3 without alpha, 4 with it (255 where the file has none)
//   most      pixels
//   why       receives one phrase when it cannot: missing, no file, no PNG, broken off, a wrong
//             checksum, a side above IMAGE_SIDE_LIMIT, no memory
// Returns false then, not reported.
bool image_read_bytes(struct image_bytes *bytes, const char *path, int channels, size_t most,
                      char why[IMAGE_WHY]);

#endif
