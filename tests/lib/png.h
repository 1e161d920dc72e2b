// png.h - for tests: PNGs of every kind, in the scratch folder, and their contents.
#ifndef TESTS_PNG_H
#define TESTS_PNG_H

#include <stdbool.h>
#include <stdint.h>

#include <png.h>

struct png_kind {
    int type, depth; // as libpng has them
    bool interlaced, transparent;
    double gamma; // that the file declares, or 0
};

// The number of samples of a pixel.
int png_channels(int type);

// Write samples, one after the other, row 0 at the top. Returns the path, like scratch_path.
const char *png_file(const char *name, const struct png_kind *kind, int width, int height,
                     const uint16_t *sample);

// Write random RGBA of 8 bits. Returns the path; texel, if not NULL, receives the bytes.
const char *png_file_random(const char *name, int width, int height, unsigned char *texel);

// The bytes of a pixel with these samples: red, green, blue and alpha, each rounded.
void png_texel(const struct png_kind *kind, const uint16_t *sample, unsigned char texel[4]);

// A number below a limit, from the same sequence in every run.
unsigned png_random(unsigned limit);

#endif
