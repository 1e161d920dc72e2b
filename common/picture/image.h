// image.h - 8-bit pictures in memory, which are written to RGB PNG files and read from PNG files of
// any kind.
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>
#include <stddef.h>

#define IMAGE_SIDE_LIMIT 16384 // longest side of an image, pixels
#define IMAGE_WHY        512   // bytes of the text that says why a file cannot be read

// A picture in memory. Row 0 is the top row; a pixel is 3 bytes: red, green, blue.
struct image {
    int width, height;    // pixels, at least 1 each
    unsigned char *pixel; // 3 * width * height bytes, owned by this struct
};

// Allocate a black picture. Reports an error and returns false if a side is out of range or memory
// is short. Free the picture with image_free.
bool image_create(struct image *image, int width, int height);

// Free the pixels. A zero-initialised struct is allowed.
void image_free(struct image *image);

// Store rows of colours as bytes: a channel v becomes floor(255 clamp(v, 0, 1) + 0.5), and a NaN
// becomes 0.
//   values  4 floats per pixel, of which the last is unused; image->width x rows pixels, bottom row
//           first
//   bottom  index of the lowest row stored, counted from the bottom of the picture
void image_store(struct image *image, const float *values, int bottom, int rows);

// Write a PNG (8-bit RGB, sRGB chunk, fast compression).
//   path  where to write; links are followed, and a target that is not a regular file is refused.
//         The picture is written to a new file, which is then renamed, so that no reader sees half
//         a file
// Returns false after reporting the error; then no new file is left, and the old one is unchanged.
bool image_write_png(const struct image *image, const char *path);

// Check before rendering whether image_write_png could write a file. If it could not, for example
// because the folder is missing or write-protected, or because the target is not a regular file,
// reports the error and returns false.
bool image_check_target(const char *path);

// The contents of a PNG.
struct image_bytes {
    int width, height, channels;
    unsigned char *value; // row 0 is the top row; freed by the caller
};

// Read a PNG of any kind, including interlaced ones, as 8 bits per channel: grey becomes equal red,
// green and blue, a palette is replaced by its colours, 16 bits are rounded to 8, and tRNS becomes
// alpha. The values are those stored in the file, whose gamma is not applied.
//   channels  3 without alpha, 4 with alpha (255 if the file has none)
//   most      the largest number of pixels that the PNG may have
//   why       receives one phrase on failure, for example that the file is missing, is not a PNG or
//             is damaged, that a side exceeds IMAGE_SIDE_LIMIT, that there are more than most
//             pixels, or that memory is short
// Returns false without reporting an error if the file cannot be read.
bool image_read_bytes(struct image_bytes *bytes, const char *path, int channels, size_t most,
                      char why[IMAGE_WHY]);

#endif
