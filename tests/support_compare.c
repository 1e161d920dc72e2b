#include "support_compare.h"

#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#include "../common/report.h"

enum { CHANNELS = 3, BLOCK = 8, SIDE_LIMIT = 16384, WHY_SIZE = 160 };

// ---- Reading ----

// libpng's errors jump to whoever called setjmp; the text waits in a buffer of WHY_SIZE.
static void on_png_error(png_structp png, png_const_charp text)
{
    snprintf(png_get_error_ptr(png), WHY_SIZE, "%s", text);
    png_longjmp(png, 1);
}

static void on_png_warning(png_structp png, png_const_charp text)
{
    (void)png, (void)text;
}

// May leave by longjmp.
static void read_png(png_structp png, png_infop info, struct image *image)
{
    png_read_info(png, info);
    png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    if (width > SIDE_LIMIT || height > SIDE_LIMIT)
        png_error(png, "a side is longer than 16384 pixels");
    png_set_scale_16(png);
    png_set_palette_to_rgb(png);
    png_set_expand_gray_1_2_4_to_8(png);
    png_set_gray_to_rgb(png);
    png_set_strip_alpha(png);
    int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    image->pixel = malloc(CHANNELS * (size_t)width * (size_t)height);
    if (image->pixel == NULL)
        png_error(png, "not enough memory");
    image->width = (int)width;
    image->height = (int)height;
    if (png_get_rowbytes(png, info) != CHANNELS * (size_t)image->width)
        png_error(png, "a kind of PNG that is not understood");
    for (int pass = 0; pass < passes; pass++)
        for (int y = 0; y < image->height; y++)
            png_read_row(png, image->pixel + (size_t)y * CHANNELS * (size_t)image->width, NULL);
    png_read_end(png, NULL);
}

static bool decode(struct image *image, FILE *file, char why[WHY_SIZE])
{
    png_structp png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, why, on_png_error, on_png_warning);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    if (info == NULL || setjmp(png_jmpbuf(png)) != 0) {
        png_destroy_read_struct(&png, &info, NULL);
        return false;
    }
    png_init_io(png, file);
    read_png(png, info, image);
    png_destroy_read_struct(&png, &info, NULL);
    return true;
}

bool image_read_png(struct image *image, const char *path)
{
    *image = (struct image){0};
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        report("%s: cannot be read: %s", path, strerror(errno));
        return false;
    }
    char why[WHY_SIZE] = "not enough memory";
    bool done = decode(image, file, why);
    if (!done) {
        report("%s: cannot be read: %s", path, ferror(file) ? strerror(errno) : why);
        image_free(image);
    }
    fclose(file);
    return done;
}

// ---- Comparing ----

static bool sizes_agree(const struct image *a, const struct image *b)
{
    if (a->width == b->width && a->height == b->height)
        return true;
    report("pictures of different size cannot be compared: %dx%d and %dx%d", a->width, a->height,
           b->width, b->height);
    return false;
}

static int largest_of_pixel(const unsigned char *a, const unsigned char *b)
{
    int largest = 0;
    for (int c = 0; c < CHANNELS; c++)
        largest = abs(a[c] - b[c]) > largest ? abs(a[c] - b[c]) : largest;
    return largest;
}

static int value_at(const struct image *image, int x, int y)
{
    return image->pixel[(size_t)y * CHANNELS * (size_t)image->width + (size_t)x];
}

// Difference of the means of the block whose first pixel is (left, top), per channel.
static void block_difference(const struct image *a, const struct image *b, int left, int top,
                             double difference[CHANNELS])
{
    int right = left + BLOCK < a->width ? left + BLOCK : a->width;
    int bottom = top + BLOCK < a->height ? top + BLOCK : a->height;
    int sum[CHANNELS] = {0};
    for (int y = top; y < bottom; y++)
        for (int x = CHANNELS * left; x < CHANNELS * right; x++)
            sum[x % CHANNELS] += value_at(b, x, y) - value_at(a, x, y);
    for (int c = 0; c < CHANNELS; c++)
        difference[c] = (double)sum[c] / ((right - left) * (bottom - top));
}

// The middle of a block, counted as --probe counts pixels: 0,0 bottom left.
static void note_place(const struct image *image, int left, int top,
                       struct image_difference *result)
{
    int right = left + BLOCK < image->width ? left + BLOCK : image->width;
    int bottom = top + BLOCK < image->height ? top + BLOCK : image->height;
    result->x = (left + right) / 2;
    result->y = image->height - 1 - (top + bottom) / 2;
}

// Fills in b8, and the place of the block that differs most.
static void compare_blocks(const struct image *a, const struct image *b,
                           struct image_difference *result)
{
    double squares[CHANNELS] = {0}, worst = 0.0, most = 0.0;
    size_t blocks = 0;
    for (int top = 0; top < a->height; top += BLOCK)
        for (int left = 0; left < a->width; left += BLOCK, blocks++) {
            double difference[CHANNELS], size = 0.0;
            block_difference(a, b, left, top, difference);
            for (int c = 0; c < CHANNELS; c++) {
                squares[c] += difference[c] * difference[c];
                size = fmax(size, fabs(difference[c]));
            }
            if (size > most)
                note_place(a, left, top, result);
            most = fmax(most, size);
        }
    for (int c = 0; c < CHANNELS; c++)
        worst = fmax(worst, squares[c]);
    result->b8 = sqrt(worst / (double)blocks);
}

bool image_compare(const struct image *a, const struct image *b, struct image_difference *result)
{
    if (!sizes_agree(a, b))
        return false;
    *result = (struct image_difference){0};
    size_t pixels = (size_t)a->width * (size_t)a->height, clear = 0;
    for (size_t i = 0; i < pixels; i++) {
        int largest = largest_of_pixel(a->pixel + CHANNELS * i, b->pixel + CHANNELS * i);
        result->largest = largest > result->largest ? largest : result->largest;
        result->differs += largest > 0;
        clear += largest > 2;
    }
    result->f2 = (double)clear / (double)pixels;
    compare_blocks(a, b, result);
    return true;
}

bool image_same(const struct image_difference *difference)
{
    return difference->f2 <= IMAGE_F2_TOLERANCE && difference->b8 <= IMAGE_B8_TOLERANCE;
}

bool image_difference_picture(const struct image *a, const struct image *b, struct image *result)
{
    if (!sizes_agree(a, b) || !image_create(result, a->width, a->height))
        return false;
    size_t bytes = CHANNELS * (size_t)a->width * (size_t)a->height;
    for (size_t i = 0; i < bytes; i++) {
        int value = 128 + 4 * (b->pixel[i] - a->pixel[i]);
        result->pixel[i] = (unsigned char)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
    return true;
}
