// panel.h - what the overlay says: chapter, rate, view, parameters, keys, one ray's march, an
// error.
#ifndef PANEL_H
#define PANEL_H

#include "picture/panel_rows.h"

// Gather the panel into the overlay's new frame.
//   width, height  of the whole picture, pixels
//   scale          as overlay_begin
void panel_gather(const struct panel *panel, struct overlay *overlay, int width, int height,
                  float scale);

#endif
