#include "lib/compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "report.h"

enum { CHANNELS = 3, BLOCK = 8 };

bool image_read_png(struct image *image, const char *path)
{
    struct image_bytes bytes;
    char why[IMAGE_WHY];
    *image = (struct image){0};
    if (!image_read_bytes(&bytes, path, CHANNELS, (size_t)-1, why)) {
        report("%s: %s", path, why);
        return false;
    }
    *image = (struct image){bytes.width, bytes.height, bytes.value};
    return true;
}

// ---- Comparing ----

static bool sizes_agree(const struct image *a, const struct image *b)
{
    if (a->width == b->width && a->height == b->height)
        return true;
    report("pictures of different sizes cannot be compared: %dx%d and %dx%d", a->width, a->height,
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

// The difference between the means of a block in the two pictures, per channel. The block's first
// pixel is (left, top).
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

static int difference_at(const struct image *a, const struct image *b, int x, int y)
{
    size_t first = CHANNELS * ((size_t)y * (size_t)a->width + (size_t)x);
    return largest_of_pixel(a->pixel + first, b->pixel + first);
}

// Store the pixel of a block that differs most, as --probe counts pixels: 0,0 is at the bottom
// left. Of several such pixels, the centre of the block is preferred.
static void note_position(const struct image *a, const struct image *b, int left, int top,
                          struct image_difference *result)
{
    int right = left + BLOCK < a->width ? left + BLOCK : a->width;
    int bottom = top + BLOCK < a->height ? top + BLOCK : a->height;
    int at[2] = {(left + right) / 2, (top + bottom) / 2};
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++)
            if (difference_at(a, b, x, y) > difference_at(a, b, at[0], at[1])) {
                at[0] = x;
                at[1] = y;
            }
    result->x = at[0];
    result->y = a->height - 1 - at[1];
}

// Fill in b8 and the position of the block that differs most.
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
                note_position(a, b, left, top, result);
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

// A share is written with two significant digits, or with three if it is at least 1 %.
const char *image_difference_words(const struct image_difference *difference, char words[256])
{
    double share = 100.0 * difference->f2;
    int largest = difference->largest, x = difference->x, y = difference->y;
    char part[32] = "less than 0.001";
    if (share >= 0.001)
        snprintf(part, sizeof part, "%.*g", share < 1.0 ? 2 : 3, share);
    if (share > 0.0)
        snprintf(words, 256,
                 "%s %% of the pixels differ by more than 2 of 255, by at most %d, most around "
                 "%d,%d",
                 part, largest, x, y);
    else if (!image_same(difference))
        snprintf(words, 256,
                 "no pixel differs by more than %d of 255, but a whole region differs a little, "
                 "most around "
                 "%d,%d",
                 largest, x, y);
    else if (largest > 0)
        snprintf(words, 256,
                 "the pictures are the same: no pixel differs by more than 2 of 255; the largest "
                 "difference is %d",
                 largest);
    else
        snprintf(words, 256, "the pictures are the same: no pixel differs");
    return words;
}

void image_print_difference(const struct image_difference *difference)
{
    printf("F2 %.4f %% B8 %.3f largest %d", 100.0 * difference->f2, difference->b8,
           difference->largest);
    if (difference->differs > 0)
        printf(" differ %zu most at %d,%d", difference->differs, difference->x, difference->y);
    printf("\n");
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
