// inspector.h - one ray in the overlay: its pixel, and its march or why there is none, in a panel
// at the right edge. Pixels are counted from the bottom left of the whole picture.
#ifndef INSPECTOR_H
#define INSPECTOR_H

#include <stdbool.h>

#include "picture/overlay.h"
#include "picture/probe.h"

// A cross around the pixel, which leaves it free.
void inspector_mark(struct overlay *overlay, const int pixel[2]);

// Where the panel begins, in units of the overlay: that of a march, or that of a reason.
float inspector_left(const struct overlay *overlay, bool marched);

// The steps of a march, the last ones where there is no room for all, and its outcome. Nothing
// where there is no room above bottom, in units.
void inspector_march(struct overlay *overlay, const int pixel[2], const struct probe *probe,
                     float bottom);

// Why there is no march to show, in as many lines as it needs.
void inspector_why(struct overlay *overlay, const char *why);

#endif
