#include "picture/panel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/comparison.h"
#include "picture/inspector.h"
#include "picture/pen.h"
#include "picture/picker.h"
#include "picture/slice.h"

#define GAP       12.0f  // distance between keys, units of the overlay
#define LEGEND    18.0f  // top of a view's legend, in cells, as in views.glsl
#define TIP_WIDTH 170.0f // maximum width of the tooltip, units
// The lower edge of the title's panel plus a margin; panels at the bottom stay below this position.
#define BELOW_TITLE (2.0f * (PEN_MARGIN + PEN_PADDING) + OVERLAY_LINE - 2.0f)

// ---- Error ----

static float widest_text(const struct overlay *overlay)
{
    return pen_picture_width(overlay) - 2.0f * (PEN_MARGIN + PEN_PADDING);
}

// Return the error or, if there is none, the note on a key or, if the panel is not folded, on an
// input without a value. Returns "" if none is shown.
static const char *words_of(const struct panel *panel)
{
    if (panel->error != NULL && panel->error[0] != '\0')
        return panel->error;
    if (panel->note != NULL)
        return panel->note;
    return panel->unset != NULL && !panel->folded ? panel->unset : "";
}

// Return the number of lines of the error that are shown. They fill at most half of the picture's
// height.
static int error_lines(const struct panel *panel, const struct overlay *overlay)
{
    char line[OVERLAY_TEXT + 1];
    int most = (int)(0.5f * pen_picture_height(overlay) / OVERLAY_LINE), lines = 0;
    for (const char *at = words_of(panel);
         lines < most && pen_next_line(&at, widest_text(overlay), line);)
        lines++;
    return lines;
}

// Return the height of the error's panel with its heading, or 0 if there is no such panel.
static float error_height(const struct panel *panel, const struct overlay *overlay)
{
    if (words_of(panel)[0] == '\0' || panel->bare)
        return 0.0f;
    float lines = (float)error_lines(panel, overlay) + 1.5f;
    return OVERLAY_LINE * lines - 2.0f + 2.0f * PEN_PADDING;
}

// Draw the error above the keys. Returns the bottom of the room that remains.
static float write_error(const struct panel *panel, struct overlay *overlay, float bottom)
{
    const char *words = words_of(panel);
    const char *heading = words == panel->unset  ? "An input without a value"
                          : words == panel->note ? panel->note_heading
                          : panel->broken
                              ? "Error: the last good picture stays until the next good save"
                              : "This cannot be shown";
    char line[OVERLAY_TEXT + 1];
    float limit = widest_text(overlay), height = error_height(panel, overlay);
    float top = bottom - height;
    if (height == 0.0f)
        return bottom;
    int lines = error_lines(panel, overlay);
    struct pen pen = pen_open(overlay, PEN_MARGIN, top, limit, height - 2.0f * PEN_PADDING);
    overlay_box(overlay, PEN_MARGIN, top, 2.0f, height, PEN_BRIGHT);
    pen_write(&pen, heading, PEN_BRIGHT);
    pen_rule(&pen, limit);
    for (const char *at = words; lines > 0 && pen_next_line(&at, limit, line); lines--)
        pen_write(&pen, line, PEN_PLAIN);
    return top - PEN_MARGIN;
}

// ---- Keys ----

// Lay out the keys in lines of limited width. The last keys are left out if there is no room.
//   pen     the pen to draw with; NULL to measure only
//   room    number of lines for which there is room; the first line is always laid out
//   widest  receives the width of the longest line
// Returns the number of lines.
static int lay_keys(const struct panel *panel, const struct pen *pen, float limit, int room,
                    float *widest)
{
    const float space = 4.0f;
    float at = 0.0f;
    int lines = 1;
    *widest = 0.0f;
    for (int i = 0; i < panel->key_count; i++) {
        const struct panel_key *key = &panel->keys[i];
        float label = overlay_width(key->label), width = label + space + overlay_width(key->does);
        if (at > 0.0f && at + width > limit) {
            if (lines >= room)
                break;
            at = 0.0f;
            lines++;
        }
        if (pen != NULL) {
            float top = pen->top + OVERLAY_LINE * (float)(lines - 1);
            overlay_text(pen->overlay, pen->left + at, top, key->label, PEN_BRIGHT);
            overlay_text(pen->overlay, pen->left + at + label + space, top, key->does, PEN_DIM);
        }
        *widest = fmaxf(*widest, at + width);
        at += width + GAP;
    }
    *widest = ceilf(*widest);
    return lines;
}

// Draw the caption at the bottom, above a legend. Returns the bottom of the room
// that remains.
static float write_caption(const struct panel *panel, struct overlay *overlay)
{
    float bottom = pen_foot(overlay, panel->renderer->view), limit = widest_text(overlay);
    float widest = 0.0f, lines = 0.0f;
    if (shader_has_legend(panel->renderer->view))
        bottom -= LEGEND * slice_cell(overlay->height) / overlay->scale;
    char line[OVERLAY_TEXT + 1];
    if (panel->caption == NULL || panel->caption[0] == '\0')
        return bottom;
    for (const char *at = panel->caption; pen_next_line(&at, limit, line); lines++)
        widest = fmaxf(widest, ceilf(overlay_width(line)));
    float height = OVERLAY_LINE * lines - 2.0f, top = bottom - height - 2.0f * PEN_PADDING;
    struct pen pen = pen_open(overlay, PEN_MARGIN, top, widest, height);
    for (const char *at = panel->caption; pen_next_line(&at, limit, line);)
        pen_write(&pen, line, PEN_BRIGHT);
    return top - PEN_MARGIN;
}

// Draw the keys above bottom, unless the error leaves no room for them. Returns the bottom of the
// room that remains.
static float write_keys(const struct panel *panel, struct overlay *overlay, float bottom)
{
    float widest;
    if (panel->key_count == 0 || panel->folded)
        return bottom;
    float limit = widest_text(overlay), error = error_height(panel, overlay);
    int room = (int)((bottom - BELOW_TITLE - 2.0f * PEN_PADDING + 2.0f) / OVERLAY_LINE);
    float height = OVERLAY_LINE * (float)lay_keys(panel, NULL, limit, room, &widest) - 2.0f;
    float top = bottom - height - 2.0f * PEN_PADDING;
    if (error > 0.0f && top - PEN_MARGIN - error < BELOW_TITLE)
        return bottom;
    struct pen pen = pen_open(overlay, PEN_MARGIN, top, widest, height);
    lay_keys(panel, &pen, limit, room, &widest);
    return top - PEN_MARGIN;
}

// ---- Help ----

// Draw the tooltip of the row under the pointer, beside the panel if there is room, otherwise below
// the row or above it.
static void write_tip(const struct panel *panel, const struct panel_rows *rows,
                      struct overlay *overlay)
{
    const struct panel_row *row = panel_rows_at(rows, panel->tip_at[0], panel->tip_at[1]);
    const char *text = panel->tip;
    char line[OVERLAY_TEXT + 1];
    float widest = 0.0f, edge = 2.0f * PEN_PADDING, picture = pen_picture_width(overlay);
    float left = rows->left + rows->width + 4.0f, room = picture - left - PEN_MARGIN - edge;
    bool beside = room >= TIP_WIDTH;
    int lines = 0;
    if (text == NULL || text[0] == '\0' || row == NULL)
        return;
    if (!beside && rows->left - PEN_MARGIN - 4.0f - edge >= TIP_WIDTH) {
        left = rows->left - 4.0f - edge - TIP_WIDTH;
        beside = true;
    } else if (!beside)
        left = rows->left;
    float limit = fmaxf(20.0f, beside ? TIP_WIDTH : picture - left - PEN_MARGIN - edge);
    for (const char *at = text; pen_next_line(&at, limit, line); lines++)
        widest = fmaxf(widest, overlay_width(line));
    float height = OVERLAY_LINE * (float)lines - 2.0f;
    float top = beside ? row->top - PEN_PADDING - 1.0f : row->top + row->height + 2.0f;
    float lowest = pen_picture_height(overlay) - PEN_MARGIN - height - edge;
    if (!beside && top > lowest)
        top = row->top - height - edge - 4.0f;
    top = fmaxf(0.0f, top < lowest ? top : lowest);
    // The tooltip may cover text of the panel, so its background is darker than the panel's.
    overlay_box(overlay, left, top, ceilf(widest) + edge, height + edge, PEN_DARK);
    struct pen pen = pen_open(overlay, left, top, ceilf(widest), height);
    for (const char *at = text; pen_next_line(&at, limit, line);)
        pen_write(&pen, line, panel->refused ? PEN_BRIGHT : PEN_PLAIN);
}

void panel_gather(const struct panel *panel, struct overlay *overlay, int width, int height,
                  float scale)
{
    overlay_begin(overlay, width, height, scale);
    if (panel->table != NULL)
        *panel->table = (struct inspector_table){0};
    bool marched = panel->pixel[0] >= 0 && panel->probe != NULL;
    bool refused = panel->pixel[0] >= 0 && !marched && panel->why != NULL;
    enum shader_view view = panel->renderer->view;
    // No panel may cover a slice's ray, which is in the middle of the slice's part of the picture.
    float middle = (view == VIEW_PLOT ? 0.5f + 0.5f * SLICE_PLOT : 0.5f) * (float)height, ray[2];
    inspector_ray(overlay, middle, ray);
    float above = shader_shows_ray(view) ? ray[1] : BELOW_TITLE;
    float bottom = comparison_write(
        panel->renderer, overlay, above,
        write_error(panel, overlay, write_keys(panel, overlay, write_caption(panel, overlay))));
    float right = pen_picture_width(overlay) - PEN_MARGIN;
    if (marched || refused)
        right = inspector_left(overlay, marched) - PEN_MARGIN;
    struct panel_rows own = {0}, *rows = panel->rows != NULL ? panel->rows : &own;
    float room = right - PEN_MARGIN - 2.0f * PEN_PADDING;
    float lowest = shader_shows_ray(view) && ray[0] < bottom ? ray[0] : bottom;
    panel_rows_build(rows, panel, room, lowest);
    // In a window, the panel may cover at most a third of the picture.
    float third = pen_picture_width(overlay) * pen_picture_height(overlay) / 3.0f;
    if (panel->rows != NULL && rows->width * rows->height > third)
        panel_rows_build(rows, panel, room, fminf(lowest, PEN_MARGIN + third / rows->width));
    // If there is no room for both the panel and the selected ray's march, only the march is shown.
    if ((panel->folded && !panel->peeks) ||
        (rows->width - 2.0f * PEN_PADDING > room && (marched || refused)))
        rows->count = 0;
    if (panel->right)
        panel_rows_move(rows, fmaxf(right - rows->width, PEN_MARGIN), PEN_MARGIN);
    if (rows->count > 0)
        panel_rows_draw(rows, panel, overlay);
    const struct inspector inspector = {.pixel = {panel->pixel[0], panel->pixel[1]},
                                        .probe = marched ? panel->probe : NULL,
                                        .side = panel->side,
                                        .shown = panel->shown,
                                        .view = view,
                                        .middle = middle};
    const struct inspector_room taken = {rows->left, rows->top, rows->left + rows->width,
                                         rows->top + rows->height};
    static const struct inspector_room nothing = {0};
    if (marched && !panel->bare && !(shader_shows_ray(view) && panel->folded)) {
        const struct inspector_room area =
            inspector_place(overlay, &inspector, rows->count > 0 ? &taken : &nothing, bottom);
        inspector_march(overlay, &inspector, &area, panel->table);
    } else if (refused && !panel->bare)
        inspector_why(overlay, panel->why);
    if (panel->pixel[0] >= 0)
        inspector_mark(overlay, &inspector);
    if (panel->picker != NULL) {
        picker_place(panel->picker, rows, overlay);
        picker_draw(panel->picker, overlay);
    }
    write_tip(panel, rows, overlay);
    panel_rows_free(&own);
}
