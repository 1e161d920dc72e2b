// reef.c - the parts of a reef and the lists of its cells, as a table of bytes. Declare the table
// as linear and clamp, and read it with texelFetch; chapters/reef.glsl explains the bytes.
#include <stdlib.h>
#include <string.h>

#include "paint.h"
#include "reef_parts.h"
#include "report.h"

enum { WIDTH = 512, TEXELS = WIDTH * 2048, SIZES = 3, HEADER = 8, BYTES = 4 };

static unsigned char table[TEXELS][BYTES]; // texel i: row i / WIDTH from the bottom
static int used = HEADER * SIZES, rows;

static void put(int texel, unsigned a, unsigned b, unsigned c, unsigned d)
{
    const unsigned byte[BYTES] = {a, b, c, d};
    for (int i = 0; texel < TEXELS && i < BYTES; i++)
        table[texel][i] = (unsigned char)byte[i];
}

// Store a byte and a whole number below 2^24 in a texel.
static void put_number(int texel, unsigned first, unsigned number)
{
    put(texel, first, number & 255U, number >> 8 & 255U, number >> 16);
}

static unsigned whole(double value, double unit)
{
    return (unsigned)(value / unit + 0.5);
}

static void put_part(int texel, const struct part *part)
{
    unsigned at[3], half[3];
    for (int i = 0; i < 3; i++) {
        at[i] = whole(part->centre[i] - part_low[i], PART_COORDINATE);
        half[i] = whole(part->half[i] + 128.0 * PART_HALF, PART_HALF);
    }
    unsigned root = 0;
    while (root * root * PART_RADIUS < part->radius)
        root++;
    put(texel, at[0] & 255U, at[0] >> 8, at[1] & 255U, at[1] >> 8);
    put(texel + 1, at[2] & 255U, at[2] >> 8, root, (unsigned)part->paint);
    put(texel + 2, half[0], half[1], half[2], 0U);
}

static bool put_reef(int number, int count)
{
    static struct part part[REEF_MOST];
    struct part_grid grid;
    reef_build(count, part);
    if (!part_grid_build(&grid, part, count, REEF_BLEND, PART_FINENESS))
        return false;
    int cells = grid.cells[0] * grid.cells[1] * grid.cells[2], header = HEADER * number;
    int parts = used, lists = parts + 3 * count, ids = lists + cells;
    used = ids + (grid.ids + 1) / 2;
    put_number(header, 0U, (unsigned)count);
    put_number(header + 1, 0U, (unsigned)parts);
    put_number(header + 2, 0U, (unsigned)lists);
    put_number(header + 3, 0U, (unsigned)ids);
    put(header + 4, (unsigned)grid.cells[0], (unsigned)grid.cells[1], (unsigned)grid.cells[2], 0U);
    put_number(header + 5, 0U, whole(grid.size, 1.0 / 4096.0));
    for (int i = 0; i < 3; i++)
        ((unsigned char *)table[header + 6])[i] =
            (unsigned char)(whole(grid.low[i] - part_low[i], 1.0 / 64.0) & 255U);
    for (int i = 0; i < 3; i++)
        ((unsigned char *)table[header + 7])[i] =
            (unsigned char)(whole(grid.low[i] - part_low[i], 1.0 / 64.0) >> 8);
    for (int i = 0; i < count; i++)
        put_part(parts + 3 * i, &part[i]);
    for (int i = 0; i < cells; i++) {
        const struct part_cell *cell = &grid.cell[i];
        double bound = cell->bound > 0.0 ? cell->bound : 0.0;
        put_number(lists + i, (unsigned)cell->count,
                   cell->count > 0 ? (unsigned)cell->first : 64U * (unsigned)(64.0 * bound));
    }
    for (int i = 0; i < grid.ids && ids + i / 2 < TEXELS; i++) {
        table[ids + i / 2][2 * (i % 2)] = (unsigned char)(grid.id[i] & 255U);
        table[ids + i / 2][2 * (i % 2) + 1] = (unsigned char)(grid.id[i] >> 8);
    }
    part_grid_free(&grid);
    return used <= TEXELS;
}

static void texel_at(double u, double v, double value[4])
{
    const unsigned char *byte = table[(int)(v * rows) * WIDTH + (int)(u * WIDTH)];
    for (int i = 0; i < BYTES; i++)
        value[i] = byte[i] / 255.0;
}

int main(void)
{
    static const int count[SIZES] = {64, 512, 4096};
    for (int i = 0; i < SIZES; i++)
        if (!put_reef(i, count[i])) {
            report("reef: not enough space in the table or not enough memory for %d parts",
                   count[i]);
            return EXIT_FAILURE;
        }
    rows = (used + WIDTH - 1) / WIDTH;
    return paint_texture(WIDTH, rows, 1, PAINT_BYTES, texel_at);
}
