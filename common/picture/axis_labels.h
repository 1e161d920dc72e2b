// axis_labels.h - the numbers and words that views write into a picture: the texture iSigns of
// shaders/signs.glsl, in the overlay's font, at a size that follows the picture's height.
#ifndef AXIS_LABELS_H
#define AXIS_LABELS_H

#include "context/gl.h"

// Zeros: empty.
struct axis_labels {
    GLuint texture;
    int cell; // pixels; a digit is 5 cells high
};

// Bind the texture to the active unit; draw it first if a picture of another height needs another
// size.
//   height  of the picture, pixels
void axis_labels_bind(struct axis_labels *labels, const struct gl *gl, int height);

// Free the texture; zeros are allowed.
void axis_labels_free(struct axis_labels *labels, const struct gl *gl);

#endif
