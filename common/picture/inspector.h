// inspector.h - the selected ray in the overlay: its position in the picture, and a panel with its
// march, or with the reason why there is none. Pixels are counted from the picture's bottom left.
#ifndef INSPECTOR_H
#define INSPECTOR_H

#include <stdbool.h>

#include "picture/overlay.h"
#include "picture/probe.h"
#include "shader/view.h"

struct inspector {
    int pixel[2];
    const struct probe *probe; // the ray's march; NULL if there is none
    const char *side;          // side of a comparison: "left" or "right"; NULL for a single picture
    float shown;               // number of steps shown, with a fraction of the next step; 0 for all
    enum shader_view view;
    float middle; // row of pixels through the ray, in the slice and plot views
};

// A rectangle of the picture, in units of the overlay from the picture's top left.
struct inspector_room {
    float left, top, right, bottom;
};

// A table as it was drawn: its edges, and its steps, one per line. If all members are 0, there is
// no table.
struct inspector_table {
    float left, top, right, bottom; // units, as in struct inspector_room
    float row;                      // the upper edge of the first step's line
    int first, rows;                // the index of the first step, and the number of steps
};

// True if a table covers a point in units. step receives the index of the step on the point's line,
// or -1 if there is none.
bool inspector_table_at(const struct inspector_table *table, const float unit[2], int *step);

// Mark the ray in the picture with a cross around its pixel, which stays uncovered, or, if the ray
// does not start at the camera, with its line and a dot for each step. The current step has a dot
// of another colour, and an arrow to the next step. Does nothing in the slice and plot views, which
// draw the ray themselves.
void inspector_mark(struct overlay *overlay, const struct inspector *inspector);

// Return the left edge, in units, of the panel on the right.
//   marched  the panel shows a march; otherwise it shows the reason why there is none
float inspector_left(const struct overlay *overlay, bool marched);

// Find the vertical extent, span[0] to span[1] in units, of the ray of a slice or plot and its
// numbers.
//   middle  as in struct inspector
void inspector_ray(const struct overlay *overlay, float middle, float span[2]);

// Find room for the table of a march: at the right edge, otherwise beside the panel on the left,
// above the ray, below it, or below the panel on the left. The first of these that does not cover
// the ray and has enough lines is chosen; if none has enough, the one with the most lines is
// chosen.
//   taken   the panel on the left; zeros if there is none
//   bottom  lower edge of the room, units
struct inspector_room inspector_place(const struct overlay *overlay,
                                      const struct inspector *inspector,
                                      const struct inspector_room *taken, float bottom);

// Draw the steps of a march, with the current step visible and marked, and the march's outcome. The
// table has as many lines as there is room for; nothing is drawn if a heading, one step and the
// outcome do not fit.
//   drawn  receives the table; may be NULL
void inspector_march(struct overlay *overlay, const struct inspector *inspector,
                     const struct inspector_room *room, struct inspector_table *drawn);

// Draw the reason why there is no march.
void inspector_why(struct overlay *overlay, const char *why);

#endif
