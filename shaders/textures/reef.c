// reef.c - the parts of a reef and the lists of its cells, as a table of whole numbers. Declare the
// table as a usampler2D; chapters/reef.glsl explains the numbers.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "paint.h"
#include "reef_parts.h"
#include "report.h"

// A texel has four words. The number of a cell without a list is EMPTY less 8 times a bound, and at
// least FIRST_EMPTY.
enum {
    WIDTH = 1024,
    ROWS = 700,
    SIZES = 3,
    WORDS = 4,
    HEADER = 2 * WORDS,
    EMPTY = 65535,
    FIRST_EMPTY = 64512
};

static uint32_t table[WIDTH * ROWS]; // the bottom row first
static int used = HEADER * SIZES;

static void put(int word, uint32_t value)
{
    if (word < WIDTH * ROWS)
        table[word] = value;
}

// Store a number below 2^16; two of them share a word.
static void put_half(int word, int number, uint32_t value)
{
    if (word + number / 2 < WIDTH * ROWS)
        table[word + number / 2] |= value << 16 * (number % 2);
}

// The first word of the next texel.
static int texel_after(int word)
{
    return (word + WORDS - 1) / WORDS * WORDS;
}

static uint32_t whole(double value, double unit)
{
    return (uint32_t)(value / unit + 0.5);
}

static void put_part(int word, const struct part *part)
{
    uint32_t at[3], half[3], root = 0;
    for (int i = 0; i < 3; i++) {
        at[i] = whole(part->centre[i] - part_low[i], PART_COORDINATE);
        half[i] = whole(part->half[i] + 128.0 * PART_HALF, PART_HALF);
    }
    while (root * root * PART_RADIUS < part->radius)
        root++;
    put(word, at[0] | at[1] << 16);
    put(word + 1, at[2] | root << 16 | (uint32_t)part->paint << 24);
    put(word + 2, half[0] | half[1] << 8 | half[2] << 16);
}

// ---- Lists ----

// The list of a cell.
struct list {
    const uint16_t *id;
    int count, cell;
};

// Longer lists come first, equal ones together.
static int compare(const void *a, const void *b)
{
    const struct list *x = a, *y = b;
    if (x->count != y->count)
        return y->count - x->count;
    int order = memcmp(x->id, y->id, (size_t)x->count * sizeof *x->id);
    return order != 0 ? order : x->cell - y->cell;
}

static bool equal(const struct list *a, const struct list *b)
{
    return a->count == b->count && memcmp(a->id, b->id, (size_t)a->count * sizeof *a->id) == 0;
}

// A chain of the positions at which each part occurs among the stored indices.
struct stream {
    uint16_t *id; // owned
    int *before;  // owned: the position before, at which the same part occurs, or -1
    int count, last[REEF_MOST];
};

// The position of a list among the indices. A list that is a part of a longer one shares its
// indices; otherwise its own are added.
static int place(struct stream *stream, const struct list *list)
{
    for (int at = stream->last[list->id[0]]; at >= 0; at = stream->before[at])
        if (at + list->count <= stream->count &&
            memcmp(stream->id + at, list->id, (size_t)list->count * sizeof *list->id) == 0)
            return at;
    int first = stream->count;
    for (int i = 0; i < list->count; i++) {
        int at = stream->count++, id = list->id[i];
        stream->id[at] = (uint16_t)id;
        stream->before[at] = stream->last[id];
        stream->last[id] = at;
    }
    return first;
}

// Store the lists: the number of each cell's list, then where each list begins and how long it is,
// then the indices. Returns false if memory or numbers are short.
static bool put_lists(int header, const struct part_grid *grid)
{
    int cells = grid->cells[0] * grid->cells[1] * grid->cells[2], many = 0, numbers = 0;
    struct list *list = calloc((size_t)cells, sizeof *list);
    int *first = calloc((size_t)cells, sizeof *first),
        *number = calloc((size_t)cells, sizeof *number);
    struct stream *stream = calloc(1, sizeof *stream);
    bool done = list != NULL && first != NULL && number != NULL && stream != NULL;
    if (done) {
        stream->id = calloc((size_t)grid->ids + 1, sizeof *stream->id);
        stream->before = calloc((size_t)grid->ids + 1, sizeof *stream->before);
        memset(stream->last, -1, sizeof stream->last);
        done = stream->id != NULL && stream->before != NULL;
    }
    for (int i = 0; done && i < cells; i++)
        if (grid->cell[i].count > 0)
            list[many++] = (struct list){grid->id + grid->cell[i].first, grid->cell[i].count, i};
    if (done)
        qsort(list, (size_t)many, sizeof *list, compare);
    for (int i = 0, leader = 0; done && i < many; i++) { // leader: the first of equal lists
        leader = i > 0 && equal(&list[i], &list[i - 1]) ? leader : i;
        number[list[i].cell] = -1 - leader;
        if (leader == i)
            first[i] = place(stream, &list[i]);
    }
    // Number the lists in the order of the cells, so that neighbours have similar numbers.
    int cells_at = texel_after(used), lists_at = texel_after(cells_at + (cells + 1) / 2);
    int *named = done ? calloc((size_t)many + 1, sizeof *named) : NULL;
    done = named != NULL;
    for (int i = 0; done && i < cells; i++) {
        double bound = grid->cell[i].bound - 0.0025 * REEF_BLEND; // pruning raises it by less
        int leader = -1 - number[i];
        if (grid->cell[i].count == 0)
            put_half(cells_at, i, EMPTY - (uint32_t)(bound > 0.0 ? 8.0 * bound : 0.0));
        else {
            if (named[leader] == 0) {
                put(lists_at + numbers,
                    (uint32_t)first[leader] | (uint32_t)list[leader].count << 24);
                named[leader] = ++numbers;
            }
            put_half(cells_at, i, (uint32_t)named[leader] - 1U);
        }
    }
    int ids_at = texel_after(lists_at + numbers);
    for (int i = 0; done && i < stream->count; i++)
        put_half(ids_at, i, stream->id[i]);
    put(header + 1, (uint32_t)(cells_at / WORDS));
    put(header + 2, (uint32_t)(lists_at / WORDS));
    put(header + 3, (uint32_t)(ids_at / WORDS));
    if (done)
        used = texel_after(ids_at + (stream->count + 1) / 2);
    free(list);
    free(first);
    free(number);
    free(named);
    if (stream != NULL) {
        free(stream->id);
        free(stream->before);
    }
    free(stream);
    return done && numbers < FIRST_EMPTY && used <= WIDTH * ROWS;
}

static bool put_reef(int number, int count)
{
    static struct part part[REEF_MOST];
    struct part_grid grid;
    int header = HEADER * number, parts = used;
    reef_build(count, part);
    if (!part_grid_build(&grid, part, count, REEF_BLEND, PART_FINENESS))
        return false;
    put(header, (uint32_t)(parts / WORDS));
    put(header + 4,
        (uint32_t)grid.cells[0] | (uint32_t)grid.cells[1] << 10 | (uint32_t)grid.cells[2] << 20);
    put(header + 5, whole(grid.size, 1.0 / 4096.0));
    put(header + 6, whole(grid.low[0] - part_low[0], 1.0 / 64.0) |
                        whole(grid.low[1] - part_low[1], 1.0 / 64.0) << 16);
    put(header + 7, whole(grid.low[2] - part_low[2], 1.0 / 64.0));
    for (int i = 0; i < count; i++)
        put_part(parts + WORDS * i, &part[i]);
    used = parts + WORDS * count;
    bool done = put_lists(header, &grid);
    part_grid_free(&grid);
    return done;
}

static int rows;

static void texel_at(double u, double v, double value[4])
{
    uint32_t word = table[(int)(v * rows) * WIDTH + (int)(u * WIDTH)];
    for (int i = 0; i < 4; i++)
        value[i] = (double)(word >> 8 * i & 255U) / 255.0;
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
