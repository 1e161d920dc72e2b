// comparison.h - the comparison of two pictures: the settings that the second takes from the first,
// the picture to which a parameter belongs, and the labels. renderer.c draws the pictures.
#ifndef COMPARISON_H
#define COMPARISON_H

#include "picture/renderer.h"

// Return the name of the side that contains column x, "left" or "right", or NULL if there is no
// second picture or x is negative.
const char *comparison_side_name(struct renderer *renderer, int width, int x);

// Copy to the second renderer the settings in which it follows the first: the view, the focal
// length, the projection, and each parameter that both have with the same type and that the second
// does not set itself. A parameter's value is clamped to its range in the second. Call this when
// one of these settings has changed. Does nothing if there is no second picture.
void comparison_follow(const struct renderer *renderer);

// The parameters that a user can change, in the order of the panel: each parameter of the first
// picture, and after it the second picture's parameter of the same name unless it follows the first
// picture's; then the parameters that only the second picture has.
//   index  0 to comparison_parameter_count - 1
// Returns NULL for any other index.
int comparison_parameter_count(const struct renderer *renderer);
struct parameter *comparison_parameter(const struct renderer *renderer, int index);

// Return the picture to which a parameter belongs: 0 for only the first, 1 for only the second, and
// -1 for both, or if there is no second picture.
int comparison_parameter_side(const struct renderer *renderer, const struct parameter *parameter);

// Return all parameters of the picture to which this parameter belongs.
const struct parameters *comparison_parameters_of(const struct renderer *renderer,
                                                  const struct parameter *parameter);

// Write a parameter's name, followed by its side unless it belongs to both pictures, as in
// "normalStep (right)".
void comparison_parameter_name(const struct renderer *renderer, const struct parameter *parameter,
                               char *text, size_t size);

// Write a side's label: the name of its picture, if there is one, then its values of the parameters
// that the second picture sets itself, and of the changed parameters that only the second picture
// has.
//   side  0 for the first picture, 1 for the second
void comparison_text(const struct renderer *renderer, int side, char *text, size_t size);

// Draw the divider, and on both sides of its lower end the labels that fit.
//   top, bottom  edges of the room for the labels, units of the overlay; the labels are left out if
//                the room is not high enough
// Returns the bottom of the room that remains.
float comparison_write(const struct renderer *renderer, struct overlay *overlay, float top,
                       float bottom);

// Begin a frame of the overlay with only the divider, without its grip, and the labels, as for a
// picture that is written to a file.
//   width, height, scale  as for overlay_begin
void comparison_gather(const struct renderer *renderer, struct overlay *overlay, int width,
                       int height, float scale);

#endif
