// picker.h - a colour chosen by the pointer: a square of saturation and value, and a bar of hues.
//
// It stands beside the panel, as close to the colour's rows as it can without covering them. What
// it shows are the screen's numbers of the colour's shares of its range: so a lamp whose light may
// be four times white is seen whole, and half-way down is half as bright to the eye. The top right
// corner is the pure hue at its brightest.
#ifndef PICKER_H
#define PICKER_H

#include "picture/overlay.h"
#include "picture/panel_rows.h"

enum picker_part { PICKER_NOTHING, PICKER_SQUARE, PICKER_BAR };

// One of zeros shows black, and stands nowhere.
struct picker {
    double hsv[3];                  // hue in turns, saturation, value, 0 to 1 each
    double value[3];                // of the parameter, that hsv is of
    float left, top, width, height; // with its edges, units; 0 wide: it is not shown
    float side;                     // of the square
};

// Find its place beside the chosen colour's rows, or, where these are not shown, none.
//   rows     as they stand
//   overlay  of this frame
void picker_place(struct picker *picker, const struct panel_rows *rows,
                  const struct overlay *overlay);

// Draw it where it stands.
void picker_draw(const struct picker *picker, struct overlay *overlay);

// True where it is, its edges too.
//   x, y  units from the picture's top left
bool picker_holds(const struct picker *picker, float x, float y);

// What of it is at a place.
enum picker_part picker_at(const struct picker *picker, float x, float y);

// Take a place of a part, or the nearest that the part has.
void picker_drag(struct picker *picker, enum picker_part part, float x, float y);

// Show the value of a colour, unless it is what picker_give gave: so a grey keeps its hue.
void picker_take(struct picker *picker, const struct parameter *colour);

// Give the colour what is shown.
void picker_give(struct picker *picker, struct parameter *colour);

#endif
