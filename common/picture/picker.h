// picker.h - a colour picker: a square of saturation and value, and a bar of hues.
//
// The picker is beside the panel or, if there is no room, over it, as close to the colour's rows as
// possible without covering them. It shows the sRGB encoding of the colour divided by its range, so
// a lamp that may be four times as bright as white fits into the square, and the middle looks half
// as bright as the top. The top right corner is the pure hue at its brightest.
#ifndef PICKER_H
#define PICKER_H

#include "picture/overlay.h"
#include "picture/panel_rows.h"

enum picker_part { PICKER_NOTHING, PICKER_SQUARE, PICKER_BAR };

// A zero-initialised picker is black and not shown.
struct picker {
    double hsv[3];                  // hue in turns, saturation, value, 0 to 1 each
    double value[3];                // the parameter's value that corresponds to this hsv
    float left, top, width, height; // including edges, units; width is 0 if the picker is hidden
    float side;                     // side of the square
};

// Place the picker beside the selected colour's rows. If these rows are not shown, neither is the
// picker.
void picker_place(struct picker *picker, const struct panel_rows *rows,
                  const struct overlay *overlay);

// Draw the picker, if it is shown.
void picker_draw(const struct picker *picker, struct overlay *overlay);

// True if a point is in the picker, including its edges.
//   x, y  units from the picture's top left
bool picker_holds(const struct picker *picker, float x, float y);

// Return the part of the picker at a point.
enum picker_part picker_at(const struct picker *picker, float x, float y);

// Choose the colour at the part's point nearest to (x, y).
void picker_drag(struct picker *picker, enum picker_part part, float x, float y);

// Show a parameter's colour. If picker_give set this colour, nothing changes, so that a grey colour
// keeps its hue.
void picker_take(struct picker *picker, const struct parameter *colour);

// Set a parameter to the colour that is shown.
void picker_give(struct picker *picker, struct parameter *colour);

#endif
