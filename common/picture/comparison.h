// comparison.h - the comparison of two pictures: the settings that the second takes from the first,
// the picture to which a parameter belongs, and the labels. renderer.h draws the pictures.
#ifndef COMPARISON_H
#define COMPARISON_H

#include "picture/renderer.h"

// The name of the side that contains column x: "left" or "right"; NULL if there is no second
// picture, or x is below 0.
const char *comparison_side_name(struct renderer *renderer, int width, int x);

// Copy to the second renderer the settings in which it follows the first: the view, the focal
// length, the projection, and each parameter that both have with the same type and that the second
// does not set itself. A parameter's value is clamped to its range in the second. Call this when
// one of these has changed. Does nothing if there is no second picture.
void comparison_follow(const struct renderer *renderer);

// The parameters that a user can change, in the order of the panel: each parameter of the first
// picture, followed by the second picture's parameter of the same name if that does not follow it;
// then the parameters that only the second picture has.
//   index  0 to comparison_parameter_count - 1
// Returns NULL for any other index.
int comparison_parameter_count(const struct renderer *renderer);
struct parameter *comparison_parameter(const struct renderer *renderer, int index);

// The picture to which a parameter belongs: 0 means only the first, 1 only the second, and -1 both,
// or the single picture if there is no second one.
int comparison_parameter_side(const struct renderer *renderer, const struct parameter *parameter);

// All parameters of the picture to which this parameter belongs.
const struct parameters *comparison_parameters_of(const struct renderer *renderer,
                                                  const struct parameter *parameter);

// A parameter's name, followed by its side unless it belongs to both pictures, as in "normalStep
// (right)".
void comparison_parameter_name(const struct renderer *renderer, const struct parameter *parameter,
                               char *text, size_t size);

// A side's label: the side's name, then its values of the parameters that the second picture sets
// itself, and of those that only the second picture has, if these were changed.
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
