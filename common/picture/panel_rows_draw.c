#include "picture/panel_rows.h"

#include <math.h>

#include "picture/colour.h"
#include "picture/pen.h"

static const struct overlay_colour BAR = {{96, 160, 224, 84}};
static const struct overlay_colour FIELD = {{0, 0, 0, 230}};

// The selected parameter has a band and a mark, so that it differs in more than its colour. If
// there is a pointer, a bar shows the position of the value in its range.
static void draw_band(const struct panel_row *row, bool pointer, struct overlay *overlay)
{
    if (row->selected)
        overlay_box(overlay, row->left - 3.0f, row->top - 2.0f, row->width + 6.0f, row->height,
                    PEN_BAND);
    if (pointer && row->fraction >= 0.0)
        overlay_box(overlay, row->left - 3.0f, row->top - 1.5f,
                    (float)row->fraction * (row->width + 6.0f), row->height - 1.0f, BAR);
}

// The typed text replaces the value; if it is too long, only its end is shown. A vertical bar marks
// the position of the next letter.
static void draw_typed(const struct panel_rows *rows, const struct panel_row *row,
                       const struct panel *panel, struct overlay *overlay)
{
    const char *text = panel->typed;
    float left = row->left + PANEL_GAP + rows->column[0] + PANEL_GAP;
    float room = row->left + row->width - left, width = overlay_width(text);
    while (*text != '\0' && width + 4.0f > room) {
        letters_next(&text);
        width = overlay_width(text);
    }
    overlay_box(overlay, left - 2.0f, row->top - 2.0f, room + 2.0f, row->height, FIELD);
    overlay_text(overlay, left, row->top, text, PEN_BRIGHT);
    overlay_box(overlay, left + width + 1.0f, row->top - 1.0f, 1.0f, row->height - 2.0f,
                PEN_BRIGHT);
}

static void draw_swatch(const struct panel_row *row, struct overlay *overlay)
{
    struct overlay_colour colour = {{0, 0, 0, 255}};
    float left = row->left + row->swatch;
    for (int k = 0; k < 3; k++)
        colour.channel[k] = (unsigned char)lround(255.0 * colour_encode(row->share[k]));
    overlay_box(overlay, left, row->top, PANEL_SWATCH, 8.0f, PEN_BRIGHT);
    overlay_box(overlay, left + 1.0f, row->top + 1.0f, PANEL_SWATCH - 2.0f, 6.0f, colour);
}

static void draw_parameter(const struct panel_rows *rows, const struct panel_row *row,
                           const struct panel *panel, struct overlay *overlay)
{
    static const struct overlay_colour *const colours[PANEL_COLUMNS] = {&PEN_PLAIN, &PEN_BRIGHT,
                                                                        &PEN_DIM, &PEN_DIM};
    float left = row->left + PANEL_GAP;
    draw_band(row, panel->rows != NULL, overlay);
    if (row->current)
        overlay_text(overlay, row->left, row->top, ">", PEN_BRIGHT);
    for (int k = 0; k < (rows->ranges ? PANEL_COLUMNS : 2); k++) {
        float beside = k == 1 && row->swatch > 0.0f ? PANEL_SWATCH + 4.0f : 0.0f;
        overlay_text(overlay, left + beside, row->top, row->cell[k],
                     row->current ? PEN_BRIGHT : *colours[k]);
        left += rows->column[k] + (rows->column[k] > 0.0f ? PANEL_GAP : 0.0f);
    }
    if (row->swatch > 0.0f)
        draw_swatch(row, overlay);
    if (panel->typed != NULL && row->selected && row->part == panel->typed_part)
        draw_typed(rows, row, panel, overlay);
}

static void draw_button(const struct panel_row *row, int button, struct overlay *overlay)
{
    const char *text = row->cell[button];
    float left = row->left + panel_row_button_left(row, button);
    if (text[0] == '\0')
        return;
    overlay_box(overlay, left - 3.0f, row->top - 1.5f, overlay_width(text) + 6.0f,
                row->height - 1.0f, PEN_BAND);
    overlay_text(overlay, left, row->top, text, PEN_PLAIN);
}

static void draw_row(const struct panel_rows *rows, int i, const struct panel *panel,
                     struct overlay *overlay)
{
    const struct panel_row *row = &rows->row[i];
    struct pen pen = {overlay, row->left, row->top};
    switch (row->kind) {
    case PANEL_ROW_TITLE:
    case PANEL_ROW_STATUS:
        overlay_text(overlay, row->left, row->top, row->cell[0], i > 0 ? PEN_PLAIN : PEN_BRIGHT);
        overlay_text(overlay, row->left + row->width - overlay_width(row->cell[1]), row->top,
                     row->cell[1], PEN_DIM);
        break;
    case PANEL_ROW_RULE:
        pen_rule(&pen, row->width);
        break;
    case PANEL_ROW_TEXT:
    case PANEL_ROW_MORE:
        overlay_text(overlay, row->left, row->top, row->cell[0], PEN_DIM);
        break;
    case PANEL_ROW_VIEW:
        draw_band(row, false, overlay);
        overlay_text(overlay, row->left + PANEL_GAP, row->top, row->cell[0],
                     row->selected ? PEN_BRIGHT : PEN_PLAIN);
        break;
    case PANEL_ROW_BUTTONS:
        for (int k = 0; k < PANEL_COLUMNS; k++)
            draw_button(row, k, overlay);
        break;
    case PANEL_ROW_DETAIL:
        draw_band(row, panel->rows != NULL, overlay);
        overlay_text(overlay, row->left + 2.0f * PANEL_GAP, row->top, row->cell[0], PEN_PLAIN);
        break;
    default:
        draw_parameter(rows, row, panel, overlay);
    }
}

void panel_rows_draw(const struct panel_rows *rows, const struct panel *panel,
                     struct overlay *overlay)
{
    pen_open(overlay, rows->left, rows->top, rows->width - 2.0f * PEN_PADDING,
             rows->height - 2.0f * PEN_PADDING);
    for (int i = 0; i < rows->count; i++)
        draw_row(rows, i, panel, overlay);
}
