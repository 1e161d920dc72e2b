// pair.h - two pictures beside each other: a divider parts the columns, what is left of it is drawn
// by one renderer, what is right of it by another, into the same targets.
//
// Both have the same camera, time, view and samples. The second follows the first's parameters, but
// for those that are its own.
#ifndef PAIR_H
#define PAIR_H

#include "picture/pass.h"

struct pair {
    struct renderer *other; // of the second picture; its own pair is NULL. Not owned
    double divider;         // share of the width that the first picture has, 0 to 1
    const char *const *own; // NAME=VALUE: parameters in which the second does not follow. Not owned
    int own_count;
    const char *label[2]; // what to call them; NULL: by their own parameters alone. Not owned
    bool gripped;         // the divider can be dragged: it shows where
};

// The first column of the second picture, in pictures of a width in pixels. The width where there
// is no second.
int pair_split(const struct renderer *renderer, int width);

// The renderer that draws a column x of pictures of this width.
struct renderer *pair_at(struct renderer *renderer, int width, int x);

// What that side is called: "left" or "right"; NULL where there is no second, or x is below 0.
const char *pair_side_name(struct renderer *renderer, int width, int x);

// Give the second renderer what it follows: view, focal length, projection, and the value of each
// parameter that both have in the same type and that is not its own, within its own range. Nothing
// where there is no second.
void pair_follow(const struct renderer *renderer);

// What a hand can change, in the order of the panel: each parameter of the first, behind it the
// second's of the same name where that does not follow, at the end what the second alone has.
//   index  0 to pair_parameter_count - 1
// Returns NULL for an index that is none.
int pair_parameter_count(const struct renderer *renderer);
struct parameter *pair_parameter(const struct renderer *renderer, int index);

// Which picture's a parameter is: 0 the first's alone, 1 the second's alone, -1 that of both, or of
// the one that there is.
int pair_parameter_side(const struct renderer *renderer, const struct parameter *parameter);

// The parameters that it is one of.
const struct parameters *pair_parameters_of(const struct renderer *renderer,
                                            const struct parameter *parameter);

// Its name, behind which stands whose it is where it is not that of both: "normalStep (right)".
void pair_parameter_name(const struct renderer *renderer, const struct parameter *parameter,
                         char *text, size_t size);

// What stands on a side's label: its name, then the parameters in which the two differ by
// themselves, and those that the second alone has and somebody has changed, with the values that
// they have now.
//   side  0 the first, 1 the second
void pair_text(const struct renderer *renderer, int side, char *text, size_t size);

// Draw the divider, and beside its lower end both labels, as far as their sides have room.
//   top, bottom  of the room for the labels, in units of the overlay; where it is too low for them
//                they are left out
// Returns what is left for others: the place of the labels' top less a margin; bottom where there
// is none.
float pair_write(const struct renderer *renderer, struct overlay *overlay, float top, float bottom);

// Gather the same alone into the overlay's new frame, as a written picture has it: without a grip.
//   width, height, scale  as overlay_begin
void pair_gather(const struct renderer *renderer, struct overlay *overlay, int width, int height,
                 float scale);

#endif
