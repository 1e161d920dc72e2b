// tiles.h - the overlay on the processor: which of its tiles a frame changes, and their pixels.
//
// Most of an overlay is the same from frame to frame: a tile is painted again only where a shape
// that touches it is new, gone or changed. Pixels are counted from the target's bottom left.
#ifndef TILES_H
#define TILES_H

#include <stdbool.h>
#include <stdint.h>

#include "picture/letters.h"

enum { TILES_SIDE = 32 };

// A box, a letter's image, or a straight line with round ends.
struct tiles_shape {
    float left, low, right, high; // pixels; of a line from (left, low) to (right, high)
    float width;                  // of a line, pixels; 0: no line
    int letter[2];                // where the image begins in the table of letters; -1: no letter
    unsigned char colour[4];      // red, green, blue, opacity
};

// One of zeros has no tiles.
struct tiles {
    int width, height;         // of the target, pixels
    int columns, rows;         // of tiles
    uint64_t *shown;           // owned: what each tile has been painted with; 0: nothing
    uint64_t *wanted;          // owned: the same of this frame
    struct tiles_shape *shape; // owned: this frame's
    int count;
};

// Begin a frame. Of another size nothing is painted yet.
void tiles_begin(struct tiles *tiles, int width, int height);

// Nothing is painted yet.
void tiles_forget(struct tiles *tiles);

// Add a shape over those before.
void tiles_add(struct tiles *tiles, const struct tiles_shape *shape);

// Paint the next tile that changed, and has anything in it.
//   from    where to look on; takes the tile's number. 0 at first, then one more than the last
//   table   of the letters, LETTERS_ROW wide
//   pixel   takes red, green, blue, opacity, the first three multiplied by the last, row by row
// Returns false where no tile is left.
bool tiles_paint(struct tiles *tiles, int *from, const unsigned char *table,
                 unsigned char pixel[TILES_SIDE * TILES_SIDE * 4]);

// The next tiles beside each other that have something in them.
//   from  as above; takes the first tile's number
// Returns how many; 0: none is left.
int tiles_run(const struct tiles *tiles, int *from);

// Free what the frames took.
void tiles_close(struct tiles *tiles);

#endif
