// panel_paint.h - the rows of the chapter's panel, drawn.
#ifndef PANEL_PAINT_H
#define PANEL_PAINT_H

#include "picture/panel_rows.h"

// Draw the rows where they stand, with the panel below them.
//   panel  of which they were built
void panel_paint(const struct panel_rows *rows, const struct panel *panel, struct overlay *overlay);

#endif
