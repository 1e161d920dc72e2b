// letters.h - the letters of the overlay: their widths, and the fraction of each pixel that they
// cover.
//
// The font is part of the program (common/picture/font/), so a text looks the same on every
// machine. Lengths are in units of the overlay.
#ifndef LETTERS_H
#define LETTERS_H

#include <stdbool.h>
#include <stdint.h>

#define LETTERS_EM       10.0f // size of the font: a capital is 7.3 units high
#define LETTERS_BASELINE 8.0f  // distance from the top of a line of text to its baseline

enum {
    LETTERS_PHASES = 4, // a letter begins at a multiple of a quarter pixel
    LETTERS_ROW = 1024  // width of the atlas in pixels, which every OpenGL driver supports
};

// The TrueType file, which the Makefile turns into an array.
extern const unsigned char letters_font[];

// Read the next character of a text, and move text past it.
//   text  UTF-8; must not be at its end
// Returns the character's code, but a space for a tab, and 0xFFFD, a question mark in a diamond,
// for bytes that are not UTF-8 and for control characters.
uint32_t letters_next(const char **text);

// The distance from the beginning of a letter to that of the next one, in units, > 0.
float letters_advance(uint32_t code);

// The image of a letter.
struct letter {
    int left, top;     // from the letter's origin on the baseline to the top left, pixels; y down
    int width, height; // pixels; 0 for a space
    int x, y;          // position of the image in the atlas, pixels
};

// An atlas of letters at one scale, each drawn when it is first needed. A struct of zeros is empty.
struct letters {
    float scale;          // pixels per unit
    unsigned char *pixel; // owned: LETTERS_ROW x rows, row 0 on top; 255 where completely covered
    int rows;
    bool grown;                  // images were added since the caller last set this to false
    struct letters_known *known; // owned
    int count;
    int right, top, bottom; // left and top of the next image, and top of the next row of images
};

// Choose a scale, in pixels per unit; images at another scale are discarded.
void letters_begin(struct letters *letters, float scale);

// The image of a letter that begins phase / LETTERS_PHASES of a pixel to the right of a pixel's
// left edge. Valid until the next call.
const struct letter *letters_find(struct letters *letters, uint32_t code, int phase);

// Free the images. A struct of zeros is allowed.
void letters_close(struct letters *letters);

#endif
