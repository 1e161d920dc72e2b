// pen.h - the look of the panels over a picture: colours, margins, lines of text.
// Lengths are in units of the overlay.
#ifndef PEN_H
#define PEN_H

#include <stdbool.h>

#include "picture/overlay.h"
#include "shader/view.h"

#define PEN_MARGIN  8.0f // distance of a panel from the picture's edge
#define PEN_PADDING 7.0f // distance of the text from the panel's edge

static const struct overlay_colour PEN_BAND = {{255, 255, 255, 38}};
static const struct overlay_colour PEN_BRIGHT = {{250, 250, 250, 255}};
static const struct overlay_colour PEN_PLAIN = {{226, 229, 234, 255}};
static const struct overlay_colour PEN_DIM = {{190, 196, 206, 255}};
static const struct overlay_colour PEN_HERE = {{255, 72, 128, 255}}; // colour of the current step
static const struct overlay_colour PEN_DARK = {{0, 0, 0, 200}};

// The position of a panel's next line.
struct pen {
    struct overlay *overlay;
    float left, top;
};

// Return the width of the picture, its height, and the lowest position of a panel's lower edge,
// which is above the axis in a slice or plot.
float pen_picture_width(const struct overlay *overlay);
float pen_picture_height(const struct overlay *overlay);
float pen_foot(const struct overlay *overlay, enum shader_view view);

// Draw a panel's background around text of this size. Returns a pen at the first line.
struct pen pen_open(struct overlay *overlay, float left, float top, float width, float height);

// Write a line of text, or draw a rule of this width, and move the pen below the line or rule.
void pen_write(struct pen *pen, const char *text, struct overlay_colour colour);
void pen_rule(struct pen *pen, float width);

// Copy the next line of a string, and advance *text past it. The line ends at a newline, or has as
// many words as fit; if not even one word fits, it has as many letters as fit, but at least one.
//   limit  width of the line, units
// Returns false at the end of the string.
bool pen_next_line(const char **text, float limit, char line[OVERLAY_TEXT + 1]);

#endif
