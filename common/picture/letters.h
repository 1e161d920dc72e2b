// letters.h - the letters of the overlay: how wide they are, and which share of each pixel they
// cover.
//
// The font is part of the program (common/picture/font/), so a text looks the same on every
// machine. Lengths are units of the overlay.
#ifndef LETTERS_H
#define LETTERS_H

#include <stdbool.h>
#include <stdint.h>

#define LETTERS_EM       10.0f // size of the font: a capital is 7.3 units high
#define LETTERS_BASELINE 8.0f  // from the top of a text to the line on which its letters stand

enum {
    LETTERS_PHASES = 4, // a letter begins at a quarter of a pixel
    LETTERS_ROW = 1024  // width of the table of images, pixels: each OpenGL allows so many
};

// The font's file, TrueType: the Makefile makes it a part of the program.
extern const unsigned char letters_font[];

// The next character of a text, and go on behind it.
//   text     UTF-8; not at its end
//   returns  its code; 0xFFFD, a question mark in a diamond, for bytes that are no UTF-8 and for
//   controls; a
//            blank for a tab
uint32_t letters_next(const char **text);

// How far the next letter stands from this one, in units, > 0.
float letters_advance(uint32_t code);

// What a letter covers.
struct letter {
    int left, top; // from the pixel where it begins, on its line, to the image's top left; y down
    int width, height; // of the image, pixels; 0 for a blank
    int x, y;          // of the image in the table
};

// Images of letters at one scale, each made when it is asked for first. One of zeros is empty.
struct letters {
    float scale;          // pixels in a unit
    unsigned char *pixel; // owned: LETTERS_ROW x rows, row 0 on top; 255 is covered whole
    int rows;
    bool grown;                  // since the caller set it to false
    struct letters_known *known; // owned
    int count;
    int right, top, bottom; // where the next image goes, and below it the next row of images
};

// Begin at a scale; all images of another one are forgotten.
void letters_begin(struct letters *letters, float scale);

// The image of a letter that begins phase / LETTERS_PHASES of a pixel right of a pixel's left edge.
// Good until the next call.
const struct letter *letters_find(struct letters *letters, uint32_t code, int phase);

// Free the images. One of zeros is allowed.
void letters_close(struct letters *letters);

#endif
