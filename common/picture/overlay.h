// overlay.h - text, boxes and lines over a picture.
//
// A frame starts with overlay_begin, collects boxes, text and lines, and is drawn as often as
// needed. Positions are in units, from the picture's top left, y down. The scale is the number of
// pixels per unit.
#ifndef OVERLAY_H
#define OVERLAY_H

#include <stdbool.h>
#include <stddef.h>

#include "context/gl.h"
#include "picture/letters.h"

#define OVERLAY_LINE          12.0f // units from one line of text to the next
#define OVERLAY_TEXT          200   // maximum bytes in a line of text; the rest is left out
#define OVERLAY_SCALE_MINIMUM 0.5
#define OVERLAY_SCALE_MAXIMUM 8.0

// Red, green, blue and opacity, 0 to 255 each.
struct overlay_colour {
    unsigned char channel[4];
};

// An axis-aligned box, the cell of one letter in its line, or a straight line.
struct overlay_rectangle {
    float left, top, right, bottom; // units; for a line, its two ends
    struct overlay_colour colour;
    uint32_t letter; // the letter's code; 0 for a box or a line
    float width;     // width of a line, units; 0 for a box or a letter
};

struct overlay {
    const struct gl *gl;
    GLuint program, vertex_array, buffer, texture;
    GLint size;                          // location of the uniform size
    float scale;                         // pixels per unit
    int width, height;                   // size of the picture, pixels
    struct overlay_rectangle *rectangle; // owned: this frame's boxes, letters and lines
    int count;
    struct letters *letters; // owned: the images of the letters at this scale
};

// Link the program that draws a frame's boxes, lines and letters.
//   gl  must outlive the overlay
// Returns false after reporting the error. Close with overlay_close in the same context.
bool overlay_open(struct overlay *overlay, const struct gl *gl);

// Free everything. A zero-initialised overlay is allowed.
void overlay_close(struct overlay *overlay);

// Return the default scale for a picture of this height in pixels: 1 up to 480 pixels, and 0.5 more
// for each further 180 pixels or part of them, but at most OVERLAY_SCALE_MAXIMUM.
float overlay_scale_of(int height);

// Start an empty frame.
//   width, height  size of the whole picture, pixels
//   scale          pixels per unit, OVERLAY_SCALE_MINIMUM to OVERLAY_SCALE_MAXIMUM
void overlay_begin(struct overlay *overlay, int width, int height, float scale);

// Add a box, or one line of text in UTF-8, with its top left corner at a position. A letter that
// the font lacks is drawn as an empty rectangle.
void overlay_box(struct overlay *overlay, float left, float top, float width, float height,
                 struct overlay_colour colour);
void overlay_text(struct overlay *overlay, float left, float top, const char *text,
                  struct overlay_colour colour);

// Add a straight line with round ends. If both ends are equal, the line is a disc.
//   width  units, > 0
void overlay_line(struct overlay *overlay, const float from[2], const float to[2], float width,
                  struct overlay_colour colour);

// Return the width of a line of text in units.
float overlay_width(const char *text);

// Blend the frame over the framebuffer that is bound for drawing, which contains the rows
// [bottom, bottom + rows) of the picture, row 0 at the bottom. Leaves blending off.
void overlay_draw(const struct overlay *overlay, int bottom, int rows);

#endif
