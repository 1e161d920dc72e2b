#include "picture/tiles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

// ---- Which tiles a frame has ----

void tiles_begin(struct tiles *tiles, int width, int height)
{
    tiles->count = 0;
    if (tiles->width != width || tiles->height != height) {
        tiles->width = width;
        tiles->height = height;
        tiles->columns = (width + TILES_SIDE - 1) / TILES_SIDE;
        tiles->rows = (height + TILES_SIDE - 1) / TILES_SIDE;
        free(tiles->shown);
        free(tiles->wanted);
        size_t count = (size_t)tiles->columns * (size_t)tiles->rows;
        tiles->shown = memory_zeros(count, sizeof *tiles->shown);
        tiles->wanted = memory_zeros(count, sizeof *tiles->wanted);
    }
    memset(tiles->wanted, 0, (size_t)tiles->columns * (size_t)tiles->rows * sizeof *tiles->wanted);
}

void tiles_forget(struct tiles *tiles)
{
    if (tiles->shown != NULL)
        memset(tiles->shown, 0,
               (size_t)tiles->columns * (size_t)tiles->rows * sizeof *tiles->shown);
}

// FNV-1a, a word at a time.
static uint64_t mix(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *at = bytes;
    for (size_t i = 0; i < size; i += sizeof(uint32_t)) {
        uint32_t word;
        memcpy(&word, at + i, sizeof word);
        hash = (hash ^ word) * 1099511628211u;
    }
    return hash;
}

// The distance of a place from a line.
static float way_to(const struct tiles_shape *line, float x, float y)
{
    float way[2] = {line->right - line->left, line->high - line->low};
    float from[2] = {x - line->left, y - line->low};
    float along = way[0] * from[0] + way[1] * from[1];
    along /= fmaxf(way[0] * way[0] + way[1] * way[1], 1e-9f);
    along = fminf(fmaxf(along, 0.0f), 1.0f);
    return hypotf(from[0] - along * way[0], from[1] - along * way[1]);
}

// The pixels that a shape may touch, from box[0], box[1] to before box[2], box[3].
static void box_of(const struct tiles_shape *shape, const int within[4], int box[4])
{
    float more = shape->width > 0.0f ? 0.5f * shape->width + 1.0f : 0.0f;
    const float edge[4] = {floorf(fminf(shape->left, shape->right) - more),
                           floorf(fminf(shape->low, shape->high) - more),
                           ceilf(fmaxf(shape->left, shape->right) + more),
                           ceilf(fmaxf(shape->low, shape->high) + more)};
    for (int i = 0; i < 4; i++)
        box[i] = (int)fminf(fmaxf(edge[i], (float)within[i % 2]), (float)within[2 + i % 2]);
}

static bool touches(const struct tiles_shape *shape, int column, int row)
{
    const float half = 0.5f * TILES_SIDE;
    return shape->width <= 0.0f ||
           way_to(shape, ((float)column + 0.5f) * TILES_SIDE, ((float)row + 0.5f) * TILES_SIDE) <=
               0.5f * shape->width + 1.0f + 1.42f * half;
}

void tiles_add(struct tiles *tiles, const struct tiles_shape *shape)
{
    const int whole[4] = {0, 0, tiles->width, tiles->height};
    int box[4];
    box_of(shape, whole, box);
    if (box[2] <= box[0] || box[3] <= box[1])
        return;
    uint64_t hash = mix(14695981039346656037u, shape, sizeof *shape);
    for (int row = box[1] / TILES_SIDE; row <= (box[3] - 1) / TILES_SIDE; row++)
        for (int column = box[0] / TILES_SIDE; column <= (box[2] - 1) / TILES_SIDE; column++)
            if (touches(shape, column, row)) {
                uint64_t *wanted = &tiles->wanted[row * tiles->columns + column];
                *wanted = mix(*wanted + 1, &hash, sizeof hash);
            }
    tiles->shape = memory_row(tiles->shape, tiles->count, sizeof *tiles->shape);
    tiles->shape[tiles->count++] = *shape;
}

// ---- Painting ----

// Blend a colour of so much opacity, 0 to 255, over a pixel.
static void blend(unsigned char *pixel, const unsigned char colour[4], unsigned opacity)
{
    for (int i = 0; i < 4; i++) {
        unsigned own = i < 3 ? colour[i] : 255u;
        pixel[i] = (unsigned char)((own * opacity + pixel[i] * (255u - opacity) + 127u) / 255u);
    }
}

// The share of a pixel that a shape covers, 0 to 1.
static float covered(const struct tiles_shape *shape, const unsigned char *table, int x, int y)
{
    if (shape->letter[0] >= 0) {
        int row = shape->letter[1] + (int)shape->high - 1 - y;
        return (float)table[row * LETTERS_ROW + shape->letter[0] + x - (int)shape->left] / 255.0f;
    }
    if (shape->width > 0.0f) {
        float way = way_to(shape, (float)x + 0.5f, (float)y + 0.5f);
        return fminf(fmaxf(0.5f * shape->width + 0.5f - way, 0.0f), 1.0f);
    }
    float across = fminf(shape->right, (float)(x + 1)) - fmaxf(shape->left, (float)x);
    float up = fminf(shape->high, (float)(y + 1)) - fmaxf(shape->low, (float)y);
    return fmaxf(across, 0.0f) * fmaxf(up, 0.0f);
}

static void paint_shape(const struct tiles_shape *shape, const unsigned char *table,
                        const int tile[4], unsigned char *pixel)
{
    int box[4];
    box_of(shape, tile, box);
    for (int y = box[1]; y < box[3]; y++)
        for (int x = box[0]; x < box[2]; x++) {
            float share = covered(shape, table, x, y);
            unsigned opacity = (unsigned)((float)shape->colour[3] * share + 0.5f);
            if (opacity > 0)
                blend(pixel + 4 * ((y - tile[1]) * TILES_SIDE + x - tile[0]), shape->colour,
                      opacity);
        }
}

bool tiles_paint(struct tiles *tiles, int *from, const unsigned char *table,
                 unsigned char pixel[TILES_SIDE * TILES_SIDE * 4])
{
    int at = *from, all = tiles->columns * tiles->rows;
    while (at < all && (tiles->wanted[at] == tiles->shown[at] || tiles->wanted[at] == 0))
        at++;
    *from = at;
    if (at >= all)
        return false;
    tiles->shown[at] = tiles->wanted[at];
    int left = at % tiles->columns * TILES_SIDE, low = at / tiles->columns * TILES_SIDE;
    const int tile[4] = {left, low, left + TILES_SIDE, low + TILES_SIDE};
    memset(pixel, 0, TILES_SIDE * TILES_SIDE * 4);
    for (int i = 0; i < tiles->count; i++)
        paint_shape(&tiles->shape[i], table, tile, pixel);
    return true;
}

int tiles_run(const struct tiles *tiles, int *from)
{
    int at = *from, all = tiles->columns * tiles->rows, count = 0;
    while (at < all && tiles->wanted[at] == 0)
        at++;
    *from = at;
    while (at + count < all && tiles->wanted[at + count] != 0 &&
           (count == 0 || (at + count) % tiles->columns != 0))
        count++;
    return count;
}

void tiles_close(struct tiles *tiles)
{
    free(tiles->shown);
    free(tiles->wanted);
    free(tiles->shape);
    *tiles = (struct tiles){0};
}
