// comparison.h - the comparison of two pictures: what the second follows, whose a parameter is, and
// what is written. renderer.h draws them.
#ifndef COMPARISON_H
#define COMPARISON_H

#include "picture/renderer.h"

// The name of the side that has column x: "left" or "right"; NULL if there is no second picture, or
// x is below 0.
const char *comparison_side_name(struct renderer *renderer, int width, int x);

// Copy to the second renderer what it follows: view, focal length, projection, and the value of
// each parameter that both have in the same type and that is not its own, within its own range. To
// be called when one of these has changed. Does nothing if there is no second picture.
void comparison_follow(const struct renderer *renderer);

// The parameters that a user can change, in the order of the panel: each of the first picture, and
// after it the second's of the same name if that does not follow; then those that only the second
// has.
//   index  0 to comparison_parameter_count - 1
// Returns NULL for any other index.
int comparison_parameter_count(const struct renderer *renderer);
struct parameter *comparison_parameter(const struct renderer *renderer, int index);

// Which picture has a parameter: 0 only the first, 1 only the second, -1 both, or there is only one
// picture.
int comparison_parameter_side(const struct renderer *renderer, const struct parameter *parameter);

// The parameters of the picture that has it.
const struct parameters *comparison_parameters_of(const struct renderer *renderer,
                                                  const struct parameter *parameter);

// Its name, followed by its side unless both have it: "normalStep (right)".
void comparison_parameter_name(const struct renderer *renderer, const struct parameter *parameter,
                               char *text, size_t size);

// A side's label: its name, then its values of the second's own settings, and of the parameters
// that only the second has and that were changed.
//   side  0 the first, 1 the second
void comparison_text(const struct renderer *renderer, int side, char *text, size_t size);

// Draw the divider, and on both sides of its lower end the labels that fit.
//   top, bottom  of the room for the labels, units of the overlay; they are left out if it is too
//                low
// Returns the bottom of the room that is left.
float comparison_write(const struct renderer *renderer, struct overlay *overlay, float top,
                       float bottom);

// Begin a frame of the overlay with the comparison alone, as a written picture has it: no grip.
//   width, height, scale  as overlay_begin
void comparison_gather(const struct renderer *renderer, struct overlay *overlay, int width,
                       int height, float scale);

#endif
