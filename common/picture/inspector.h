// inspector.h - one ray in the overlay: where it is in the picture, and in a panel its march or why
// there is none. Pixels are counted from the bottom left of the whole picture.
#ifndef INSPECTOR_H
#define INSPECTOR_H

#include <stdbool.h>

#include "picture/overlay.h"
#include "picture/probe.h"
#include "shader/form.h"

// A ray that is looked at.
struct inspector {
    int pixel[2];
    const struct probe *probe; // its march
    const char *side; // of two pictures, whose it is: "left" or "right"; NULL: there is one
    float shown;      // how many of its steps, with a part of the next; 0: all
    enum shader_view view;
    float middle; // of slice and plot: the row in which the ray runs, pixels
};

// A part of the picture, in units of the overlay from its top left.
struct inspector_room {
    float left, top, right, bottom;
};

// Mark the ray in the picture: a cross around its pixel, which leaves the pixel free; for a ray
// that is seen from elsewhere than it starts its line with a dot for each step. The step that is
// looked at is a dot of its own, with an arrow to the next one. Nothing in slice and plot, which
// draw that themselves.
void inspector_mark(struct overlay *overlay, const struct inspector *inspector);

// Where the panel of a march begins at the right edge, in units; or that of a reason.
float inspector_left(const struct overlay *overlay, bool marched);

// Which heights, in units, the ray of a slice or plot takes with its numbers: span[0] to span[1].
//   middle  as of struct inspector
void inspector_ray(const struct overlay *overlay, float middle, float span[2]);

// Find the room for the table of a march: at the right edge, else beside what stands at the left
// edge, over the ray, under it, or under what stands at the left; the first that covers neither the
// ray nor its end, and has lines enough.
//   taken   what stands at the left edge; zeros: nothing
//   bottom  of all room, units
struct inspector_room inspector_place(const struct overlay *overlay,
                                      const struct inspector *inspector,
                                      const struct inspector_room *taken, float bottom);

// The steps of a march, with the one that is looked at in sight and marked, and its outcome. As
// many lines as the room has; nothing where it has not two.
void inspector_march(struct overlay *overlay, const struct inspector *inspector,
                     const struct inspector_room *room);

// Why there is no march to show, in as many lines as it needs.
void inspector_why(struct overlay *overlay, const char *why);

#endif
