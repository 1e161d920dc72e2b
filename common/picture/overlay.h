// overlay.h - text and boxes over a picture.
//
// A frame is gathered by overlay_begin, overlay_box and overlay_text, then drawn as often as
// needed. Places are in units of the scale, from the picture's top left, y down: at scale 2 a unit
// is two pixels wide.
#ifndef OVERLAY_H
#define OVERLAY_H

#include <stdbool.h>
#include <stddef.h>

#include "context/gl.h"
#include "picture/letters.h"
#include "picture/tiles.h"

#define OVERLAY_LINE          12.0f // units from one line of text to the next
#define OVERLAY_TEXT          200   // bytes of one line of text; more are left out
#define OVERLAY_SCALE_MINIMUM 0.5
#define OVERLAY_SCALE_MAXIMUM 8.0

// Red, green, blue and opacity, 0 to 255 each.
struct overlay_colour {
    unsigned char channel[4];
};

// One axis-parallel box, the room of one letter in its line, or a straight line.
struct overlay_rectangle {
    float left, top, right, bottom; // units; of a line its ends
    struct overlay_colour colour;
    uint32_t letter; // its code; 0 for a box or a line
    float width;     // of a line, units; 0: no line
};

struct overlay {
    const struct gl *gl;
    GLuint program, vertex_array, buffer, texture;
    float scale;                         // pixels in a unit
    int width, height;                   // of the picture, pixels
    struct overlay_rectangle *rectangle; // owned: this frame's boxes and letters
    int count;
    struct letters *letters; // owned: their images at this scale
    struct tiles *tiles;     // owned: what texture shows of the last frame that was drawn
};

// Compile the small program that shows what the processor has painted.
//   gl  must outlive the overlay
// Returns false, reported. Close with overlay_close in the same context.
bool overlay_open(struct overlay *overlay, const struct gl *gl);

// Free what overlay_open and the frames took. One of zeros is allowed.
void overlay_close(struct overlay *overlay);

// The scale that suits a picture of a height in pixels: 1 up to 480, half a step more for each 180.
float overlay_scale_of(int height);

// Forget the frame before.
//   width, height  of the whole picture, pixels
//   scale          pixels in a unit, OVERLAY_SCALE_MINIMUM to OVERLAY_SCALE_MAXIMUM
void overlay_begin(struct overlay *overlay, int width, int height, float scale);

// Add a box, or one line of text in UTF-8 whose top left is at a place. What the font has not is
// drawn as an empty frame, what is no text as letters_next says.
void overlay_box(struct overlay *overlay, float left, float top, float width, float height,
                 struct overlay_colour colour);
void overlay_text(struct overlay *overlay, float left, float top, const char *text,
                  struct overlay_colour colour);

// Add a straight line with round ends, from one place to another; a disc where both are one.
//   width  units, > 0
void overlay_line(struct overlay *overlay, const float from[2], const float to[2], float width,
                  struct overlay_colour colour);

// The width of a line of text in units.
float overlay_width(const char *text);

// Blend the frame over what is in the framebuffer that is bound for drawing, which holds the rows
// [bottom, bottom + rows) of the picture, row 0 being the lowest. What it shares with the frame
// that was drawn before is not painted again. Leaves blending off.
void overlay_draw(const struct overlay *overlay, int bottom, int rows);

#endif
