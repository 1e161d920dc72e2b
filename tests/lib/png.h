// png.h - for tests: writes PNGs of every kind to the scratch folder, and returns the pixels that a
// reader must find in them.
#ifndef TESTS_PNG_H
#define TESTS_PNG_H

#include <stdbool.h>
#include <stdint.h>

#include <png.h>

struct png_kind {
    int type, depth; // as in libpng
    bool interlaced, transparent;
    double gamma; // the gamma that the file declares; 0 if it declares none
};

// The number of samples per pixel.
int png_channels(int type);

// Write a PNG of these samples, row 0 at the top. Returns its path, like scratch_path.
const char *png_file(const char *name, const struct png_kind *kind, int width, int height,
                     const uint16_t *sample);

// Write a PNG of random RGBA pixels with 8 bits per channel. Returns its path. texel receives the
// bytes, and may be NULL.
const char *png_file_random(const char *name, int width, int height, unsigned char *texel);

// The expected bytes of a pixel with these samples: red, green, blue and alpha, each rounded.
void png_texel(const struct png_kind *kind, const uint16_t *sample, unsigned char texel[4]);

// A random number below a limit, from the same sequence in every run.
unsigned png_random(unsigned limit);

#endif
