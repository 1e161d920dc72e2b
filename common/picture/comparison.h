// comparison.h - the comparison of two pictures: what the second takes from the first, which of
// them has a parameter, and their labels. renderer.h draws the pictures.
#ifndef COMPARISON_H
#define COMPARISON_H

#include "picture/renderer.h"

// The name of the side that contains column x: "left" or "right"; NULL if there is no second
// picture, or x is below 0.
const char *comparison_side_name(struct renderer *renderer, int width, int x);

// Copy to the second renderer what it follows: the view, the focal length, the projection, and the
// value, clamped to its own range, of each parameter that both have with the same type and that the
// second does not set itself. Call this when one of these has changed. Does nothing if there is no
// second picture.
void comparison_follow(const struct renderer *renderer);

// The parameters that a user can change, in the order of the panel: each parameter of the first
// picture, followed by the second's of the same name if that does not follow the first's; then
// those that only the second has.
//   index  0 to comparison_parameter_count - 1
// Returns NULL for any other index.
int comparison_parameter_count(const struct renderer *renderer);
struct parameter *comparison_parameter(const struct renderer *renderer, int index);

// Which picture has a parameter: 0 the first only, 1 the second only, -1 both, or if there is only
// one picture.
int comparison_parameter_side(const struct renderer *renderer, const struct parameter *parameter);

// All parameters of the picture that has this one.
const struct parameters *comparison_parameters_of(const struct renderer *renderer,
                                                  const struct parameter *parameter);

// A parameter's name, followed by its side unless both pictures have it: "normalStep (right)".
void comparison_parameter_name(const struct renderer *renderer, const struct parameter *parameter,
                               char *text, size_t size);

// A side's label: its name, then its values of the parameters that the second sets itself, and of
// those that only the second has, if they were changed.
//   side  0 the first, 1 the second
void comparison_text(const struct renderer *renderer, int side, char *text, size_t size);

// Draw the divider, and on both sides of its lower end the labels that fit.
//   top, bottom  of the room for the labels, units of the overlay; the labels are left out if it is
//                not high enough
// Returns the bottom of the room that remains.
float comparison_write(const struct renderer *renderer, struct overlay *overlay, float top,
                       float bottom);

// Begin a frame of the overlay that has only the comparison, without its grip, as for a picture
// that is written to a file.
//   width, height, scale  as for overlay_begin
void comparison_gather(const struct renderer *renderer, struct overlay *overlay, int width,
                       int height, float scale);

#endif
