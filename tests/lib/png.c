#include "lib/png.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
// cmocka.h needs the four headers above.
#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lib/scratch.h"

static const png_color palette[16] = {{1, 2, 3}, {250, 0, 9},  {7, 99, 8},     {0, 0, 255},
                                      {9, 9, 9}, {40, 50, 60}, {255, 255, 255}};
static const png_byte palette_alpha[3] = {0, 100, 255};
static const png_color_16 clear = {.red = 3, .green = 3, .blue = 3, .gray = 1};

int png_channels(int type)
{
    return type == PNG_COLOR_TYPE_RGB          ? 3
           : type == PNG_COLOR_TYPE_RGB_ALPHA  ? 4
           : type == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                               : 1;
}

static void describe(png_structp png, png_infop info, const struct png_kind *kind, int width,
                     int height)
{
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, kind->depth, kind->type,
                 kind->interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    bool indexed = kind->type == PNG_COLOR_TYPE_PALETTE;
    if (indexed)
        png_set_PLTE(png, info, palette, kind->depth < 4 ? 1 << kind->depth : 16);
    if (kind->transparent)
        png_set_tRNS(png, info, indexed ? palette_alpha : NULL, indexed ? 2 : 0,
                     indexed ? NULL : &clear);
    if (kind->gamma > 0.0)
        png_set_gAMA(png, info, kind->gamma);
}

const char *png_file(const char *name, const struct png_kind *kind, int width, int height,
                     const uint16_t *sample)
{
    const char *path = scratch_path(name);
    FILE *file = fopen(path, "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    size_t bytes = kind->depth == 16 ? 2 : 1, row = (size_t)(png_channels(kind->type) * width);
    png_byte *data = malloc(row * bytes * (size_t)height);
    assert_true(file != NULL && info != NULL);
    assert_non_null(data);
    for (size_t i = 0; i < row * (size_t)height; i++)
        if (bytes == 2) {
            data[2 * i] = (png_byte)(sample[i] >> 8);
            data[2 * i + 1] = (png_byte)sample[i];
        } else
            data[i] = (png_byte)sample[i];
    png_init_io(png, file);
    describe(png, info, kind, width, height);
    png_write_info(png, info);
    png_set_packing(png);
    int passes = png_set_interlace_handling(png);
    for (int pass = 0; pass < passes; pass++)
        for (int y = 0; y < height; y++)
            png_write_row(png, data + (size_t)y * row * bytes);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    free(data);
    fclose(file);
    return path;
}

static uint32_t random_state = 1;

unsigned png_random(unsigned limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) % limit;
}

const char *png_file_random(const char *name, int width, int height, unsigned char *texel)
{
    const struct png_kind kind = {.type = PNG_COLOR_TYPE_RGB_ALPHA, .depth = 8};
    size_t count = 4 * (size_t)width * (size_t)height;
    uint16_t *sample = malloc(count * sizeof *sample);
    assert_non_null(sample);
    for (size_t i = 0; i < count; i++) {
        sample[i] = (uint16_t)png_random(256);
        if (texel != NULL)
            texel[i] = (unsigned char)sample[i];
    }
    const char *path = png_file(name, &kind, width, height, sample);
    free(sample);
    return path;
}

// A sample converted to 8 bits.
static unsigned char byte_of(unsigned sample, int depth)
{
    return (unsigned char)floor(255.0 * sample / ((1 << depth) - 1) + 0.5);
}

void png_texel(const struct png_kind *kind, const uint16_t *sample, unsigned char texel[4])
{
    bool grey = kind->type == PNG_COLOR_TYPE_GRAY || kind->type == PNG_COLOR_TYPE_GRAY_ALPHA;
    int channels = png_channels(kind->type);
    bool hidden = kind->transparent;
    if (kind->type == PNG_COLOR_TYPE_PALETTE) {
        const png_color *colour = &palette[sample[0]];
        bool listed = kind->transparent && sample[0] < 2;
        texel[0] = colour->red;
        texel[1] = colour->green;
        texel[2] = colour->blue;
        texel[3] = listed ? palette_alpha[sample[0]] : 255;
        return;
    }
    for (int i = 0; i < 3; i++) {
        texel[i] = byte_of(sample[grey ? 0 : i], kind->depth);
        hidden = hidden && sample[grey ? 0 : i] == (grey ? clear.gray : clear.red);
    }
    texel[3] = channels % 2 == 0 ? byte_of(sample[channels - 1], kind->depth) : 255;
    if (hidden)
        texel[3] = 0;
}
