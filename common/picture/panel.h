// panel.h - the overlay of a picture: chapter, rate, view, parameters, keys, one ray's march, and
// an error.
#ifndef PANEL_H
#define PANEL_H

#include "picture/panel_rows.h"

// Begin a frame of the overlay, and add the panels.
//   width, height  size of the whole picture, pixels
//   scale          as for overlay_begin
void panel_gather(const struct panel *panel, struct overlay *overlay, int width, int height,
                  float scale);

#endif
