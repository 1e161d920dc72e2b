// axis_labels.h - the digits and words that views write into a picture, in the overlay's font. They
// are in the texture iSigns of shaders/signs.glsl.
#ifndef AXIS_LABELS_H
#define AXIS_LABELS_H

#include "context/gl.h"

#define AXIS_LABELS_DIGIT 5 // height of a digit, cells

// A zero-initialised struct is empty.
struct axis_labels {
    GLuint texture;
    int cell; // side of a cell, pixels
};

// Bind the texture to the active texture unit, and redraw it if the size of its cells has changed.
//   cell  side of a cell in pixels, at least 1
void axis_labels_bind(struct axis_labels *labels, const struct gl *gl, int cell);

// Free the texture. A zero-initialised struct is allowed.
void axis_labels_free(struct axis_labels *labels, const struct gl *gl);

#endif
