// inspector.h - the selected ray in the overlay: its position in the picture, and a panel with its
// march, or with the reason why there is none. Pixels are counted from the picture's bottom left.
#ifndef INSPECTOR_H
#define INSPECTOR_H

#include <stdbool.h>

#include "picture/overlay.h"
#include "picture/probe.h"
#include "shader/dialect.h"

struct inspector {
    int pixel[2];
    const struct probe *probe; // its march
    const char *side;          // of a comparison: "left" or "right"; NULL: there is one picture
    float shown;               // number of steps, with a fraction of the next one; 0: all
    enum shader_view view;
    float middle; // of slice and plot: the row of the ray, pixels
};

// A part of the picture, in units of the overlay from its top left.
struct inspector_room {
    float left, top, right, bottom;
};

// A table as it was drawn: its edges, and its steps, one line each. Zeros: none.
struct inspector_table {
    float left, top, right, bottom; // units, as in struct inspector_room
    float row;                      // the upper edge of the first step's line
    int first, rows;                // that step, and how many there are
};

// True if a table covers a point in units. step receives the step on that line, or -1.
bool inspector_table_at(const struct inspector_table *table, const float unit[2], int *step);

// Mark the ray in the picture: a cross around its pixel, which stays free; or, if it starts
// elsewhere than at the camera, its line with a dot for each step. The current step has a dot of
// its own, and an arrow to the next one. Does nothing in slice and plot, which draw the ray
// themselves.
void inspector_mark(struct overlay *overlay, const struct inspector *inspector);

// The left edge of the panel at the right, in units: of a march, or of a reason.
float inspector_left(const struct overlay *overlay, bool marched);

// The heights of the ray of a slice or plot with its numbers, in units: span[0] to span[1].
//   middle  as in struct inspector
void inspector_ray(const struct overlay *overlay, float middle, float span[2]);

// Find room for the table of a march: at the right edge, otherwise beside the panel at the left,
// above the ray, below it, or below the panel at the left. It is the first that does not cover the
// ray and has enough lines.
//   taken   the panel at the left; zeros: none
//   bottom  of the room, units
struct inspector_room inspector_place(const struct overlay *overlay,
                                      const struct inspector *inspector,
                                      const struct inspector_room *taken, float bottom);

// Draw the steps of a march, with the current one visible and marked, and its outcome. It has as
// many lines as there is room for; nothing is drawn if there are fewer than two.
//   drawn  receives the table; NULL: not wanted
void inspector_march(struct overlay *overlay, const struct inspector *inspector,
                     const struct inspector_room *room, struct inspector_table *drawn);

// Draw the reason why there is no march.
void inspector_why(struct overlay *overlay, const char *why);

#endif
