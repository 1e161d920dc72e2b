// signs.h - the numbers and words that views write into a picture, as the texture iSigns of
// shaders/signs.glsl: the overlay's font, of a size that follows the picture's height.
#ifndef SIGNS_H
#define SIGNS_H

#include "context/gl.h"

// Of the table, in cells. Rows are 8 high and stand on a line 2 above their lower ends.
enum { SIGNS_WIDTH = 48, SIGNS_ROW = 8, SIGNS_LINE = 2, SIGNS_ROWS = 7 };

// Draw the table: which share of each pixel is covered, 255 the whole, the first row at the bottom.
// Row 0 holds the digits, the point and the minus, each in the middle of 4 cells, the point of 2;
// each further one a word.
//   cell  its side, pixels, > 0
// Returns SIGNS_WIDTH * cell by SIGNS_ROWS * SIGNS_ROW * cell bytes, the caller's.
unsigned char *signs_draw(int cell);

// A table of images. One of zeros is empty.
struct signs {
    GLuint texture;
    int cell; // pixels; a digit is 5 cells high
};

// Bind the table to the texture unit that is active, made anew when a picture of another height
// asks for another size: a cell is 1 / 180 of the height, rounded down, and at least a pixel.
//   height  of the picture, pixels
void signs_bind(struct signs *signs, const struct gl *gl, int height);

// Free the texture. One of zeros is allowed.
void signs_free(struct signs *signs, const struct gl *gl);

#endif
