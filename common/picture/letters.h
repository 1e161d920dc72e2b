// letters.h - the letters of the overlay: their widths, and the fraction of each pixel that they
// cover.
//
// The font is part of the program (common/picture/font/), so text looks the same on every machine.
// Lengths are in units of the overlay.
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

// Read the next character of a string, and advance *text past it.
//   text  UTF-8; must not be empty
// Returns the character's code, but a space for a tab, and 0xFFFD, a question mark in a diamond,
// instead of all that report_next replaces.
uint32_t letters_next(const char **text);

// Return the distance from the beginning of a letter to that of the next one, in units. It is
// positive.
float letters_advance(uint32_t code);

// The image of a letter.
struct letter {
    int left, top;     // offset of the top left from the origin on the baseline, pixels; y down
    int width, height; // pixels; 0 for a space
    int x, y;          // position of the image in the atlas, pixels
};

// An atlas of letters at one scale, each drawn when it is first needed. A zero-initialised atlas is
// empty.
struct letters {
    float scale;          // pixels per unit
    unsigned char *pixel; // owned: LETTERS_ROW x rows bytes, row 0 at the top; 255 is fully covered
    int rows;
    bool grown;                  // images were added since the caller last set this to false
    struct letters_known *known; // owned
    int count;
    int right, top, bottom; // left and top of the next image, and top of the next row of images
};

// Choose a scale, in pixels per unit; images at another scale are discarded.
void letters_begin(struct letters *letters, float scale);

// Return the image of a letter that begins phase / LETTERS_PHASES of a pixel to the right of a
// pixel's left edge. The image is valid until the next call.
const struct letter *letters_find(struct letters *letters, uint32_t code, int phase);

// Free the images. A zero-initialised struct is allowed.
void letters_close(struct letters *letters);

#endif
