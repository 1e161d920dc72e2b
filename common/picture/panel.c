#include "picture/panel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/inspector.h"
#include "picture/pair.h"
#include "picture/pen.h"
#include "picture/plot.h"

#define GAP 12.0f // units of the overlay, between columns

static float larger(float a, float b)
{
    return a > b ? a : b;
}

// ---- Chapter, view, parameters ----

enum { COLUMNS = 4, CELL = 160 };

// Name, value, range and unit of a parameter.
static void fill_cells(const struct parameter *parameter, char cell[COLUMNS][CELL])
{
    snprintf(cell[0], CELL, "%s", parameter->name);
    parameter_value_text(parameter, cell[1], CELL);
    parameter_range_text(parameter, cell[2], CELL);
    snprintf(cell[3], CELL, "%s", parameter->unit);
}

// What the chapter's panel shows, and how wide. There are two forms: the small one lists names and
// values, and the range and the unit of the chosen parameter alone, so that the picture stays in
// sight; the large one has a table with all four columns.
struct chapter_panel {
    float column[COLUMNS]; // widths
    float width;
    bool ranges;
    int first, rows; // of the parameters, those that there is room for
    bool cut;        // not all
    float lines;
    char status[160], detail[2 * CELL], last[160];
    char textures[CELL]; // the large form names them; "" for none
};

static void detail_text(const struct parameter *parameter, char *text, size_t size)
{
    char cell[COLUMNS][CELL];
    fill_cells(parameter, cell);
    snprintf(text, size, "%s %s", cell[2], cell[3]);
}

// The width of the table of the first columns, or of the widest detail below one of its lines.
static float measure_table(const struct parameters *parameters, int columns, float width[COLUMNS])
{
    char cell[COLUMNS][CELL], detail[2 * CELL];
    float sum = parameters->count > 0 ? GAP : 0.0f, widest = 0.0f;
    memset(width, 0, COLUMNS * sizeof *width);
    for (int i = 0; i < parameters->count; i++) {
        fill_cells(&parameters->item[i], cell);
        detail_text(&parameters->item[i], detail, sizeof detail);
        widest = larger(widest, 2.0f * GAP + overlay_width(detail));
        for (int k = 0; k < columns; k++)
            width[k] = larger(width[k], overlay_width(cell[k]));
    }
    for (int k = 0; k < columns; k++)
        sum += width[k] + (k > 0 && width[k] > 0.0f ? GAP : 0.0f);
    return columns < COLUMNS ? larger(sum, widest) : sum;
}

// The chosen parameter has a mark and a band, so that no colour has to tell it.
static void write_parameter(struct pen *pen, const struct parameter *parameter, bool chosen,
                            const struct chapter_panel *form)
{
    static const struct overlay_colour *const colours[COLUMNS] = {&PEN_PLAIN, &PEN_BRIGHT, &PEN_DIM,
                                                                  &PEN_DIM};
    char cell[COLUMNS][CELL];
    fill_cells(parameter, cell);
    bool detailed = chosen && !form->ranges;
    if (chosen) {
        overlay_box(pen->overlay, pen->left - 3.0f, pen->top - 2.0f, form->width + 6.0f,
                    detailed ? 2.0f * OVERLAY_LINE : OVERLAY_LINE, PEN_BAND);
        overlay_text(pen->overlay, pen->left, pen->top, ">", PEN_BRIGHT);
    }
    float left = pen->left + GAP;
    for (int k = 0; k < (form->ranges ? COLUMNS : 2); k++) {
        overlay_text(pen->overlay, left, pen->top, cell[k], chosen ? PEN_BRIGHT : *colours[k]);
        left += form->column[k] + (form->column[k] > 0.0f ? GAP : 0.0f);
    }
    pen->top += OVERLAY_LINE;
    if (detailed) {
        overlay_text(pen->overlay, pen->left + 2.0f * GAP, pen->top, form->detail, PEN_PLAIN);
        pen->top += OVERLAY_LINE;
    }
}

static void status_text(const struct panel *panel, char *text, size_t size)
{
    snprintf(text, size, "view: %s", shader_view_name(panel->renderer->view));
    size_t used = strlen(text);
    if (panel->rate > 0.0)
        snprintf(text + used, size - used, "    %.0f fps, %.1f ms", panel->rate,
                 panel->milliseconds);
    used = strlen(text);
    if (panel->timed)
        snprintf(text + used, size - used, "    time %.1f s", panel->time);
    used = strlen(text);
    if (panel->paused)
        snprintf(text + used, size - used, "    paused");
}

// The last line: that the picture is coarse, or what to press.
static void last_text(const struct panel *panel, char *text, size_t size)
{
    bool coarse = panel->resolution > 0 && panel->resolution < 100;
    if (coarse && panel->sharp == 0)
        snprintf(text, size, "%d %% resolution while moving", panel->resolution);
    else if (coarse && panel->sharp < 100)
        snprintf(text, size, "%d %% resolution; sharpening: %d %%", panel->resolution,
                 panel->sharp);
    else
        snprintf(text, size, "%s", panel->hint != NULL ? panel->hint : "");
}

static void textures_text(const struct panel *panel, char text[CELL])
{
    const struct textures *textures = &panel->renderer->textures;
    text[0] = '\0';
    for (int i = 0; i < textures->count; i++) {
        size_t used = strlen(text);
        snprintf(text + used, CELL - used, "%s%s",
                 i > 0 ? ", " : "textures: ", textures->item[i].name);
    }
}

// The first of the parameters to show where there is room for a number of them: the chosen one
// stays in sight.
static int first_shown(const struct panel *panel, int room)
{
    const struct parameter *first = panel->renderer->parameters.item;
    int index = panel->chosen != NULL ? (int)(panel->chosen - first) : 0;
    return index < room ? 0 : index - room + 1;
}

// Lay the panel out.
//   limit   width of the text at most, where the small form can keep it
//   bottom  of the panel at most
static void lay_chapter(const struct panel *panel, float limit, float bottom,
                        struct chapter_panel *form)
{
    const struct parameters *parameters = &panel->renderer->parameters;
    *form = (struct chapter_panel){.rows = parameters->count};
    status_text(panel, form->status, sizeof form->status);
    last_text(panel, form->last, sizeof form->last);
    if (panel->chosen != NULL)
        detail_text(panel->chosen, form->detail, sizeof form->detail);
    float table = measure_table(parameters, COLUMNS, form->column);
    form->ranges = panel->chosen == NULL || (panel->ranges && table <= limit);
    if (!form->ranges)
        table = measure_table(parameters, 2, form->column);
    if (form->ranges)
        textures_text(panel, form->textures);
    // In steps, so that a panel does not tremble with its numbers.
    float texts = larger(overlay_width(form->status), overlay_width(form->last));
    texts = larger(texts, overlay_width(form->textures));
    texts = 20.0f * ceilf(larger(overlay_width(panel->title), texts) / 20.0f);
    form->width = ceilf(larger(texts, table));
    form->lines = 2.0f + (parameters->count > 0 ? 0.5f : 0.0f) + (form->ranges ? 0.0f : 1.0f) +
                  (form->last[0] != '\0' ? 1.5f : 0.0f) + (form->textures[0] != '\0' ? 1.0f : 0.0f);
    int room =
        (int)((bottom - PEN_MARGIN - 2.0f * PEN_PADDING + 2.0f) / OVERLAY_LINE - form->lines);
    form->cut = parameters->count > room;
    if (form->cut)
        form->rows = room > 1 ? room - 1 : 0;
    if (form->rows == 0 && !form->ranges)
        form->lines -= 1.0f;
    form->lines += (float)form->rows + (form->cut ? 1.0f : 0.0f);
    form->first = first_shown(panel, form->rows);
}

static void write_chapter(const struct panel *panel, struct overlay *overlay,
                          const struct chapter_panel *form)
{
    const struct parameters *parameters = &panel->renderer->parameters;
    struct pen pen =
        pen_open(overlay, PEN_MARGIN, PEN_MARGIN, form->width, OVERLAY_LINE * form->lines - 2.0f);
    pen_write(&pen, panel->title, PEN_BRIGHT);
    pen_write(&pen, form->status, PEN_PLAIN);
    if (parameters->count > 0)
        pen_rule(&pen, form->width);
    for (int i = form->first; i < form->first + form->rows; i++)
        write_parameter(&pen, &parameters->item[i], &parameters->item[i] == panel->chosen, form);
    char part[64];
    snprintf(part, sizeof part, "%d to %d of %d", form->rows > 0 ? form->first + 1 : 0,
             form->first + form->rows, parameters->count);
    if (form->cut)
        pen_write(&pen, part, PEN_DIM);
    if (form->textures[0] != '\0')
        pen_write(&pen, form->textures, PEN_DIM);
    if (form->last[0] != '\0') {
        pen_rule(&pen, form->width);
        pen_write(&pen, form->last, PEN_DIM);
    }
}

// ---- Keys ----

// Lay the keys out in lines of a width. With an overlay they are drawn from the pen on; without,
// only counted.
//   widest  takes the width of the longest line
// Returns the number of lines.
static int lay_keys(const struct panel *panel, const struct pen *pen, float limit, float *widest)
{
    const float space = 4.0f;
    float at = 0.0f;
    int lines = 1;
    *widest = 0.0f;
    for (int i = 0; i < panel->key_count; i++) {
        const struct panel_key *key = &panel->keys[i];
        float label = overlay_width(key->label), width = label + space + overlay_width(key->does);
        if (at > 0.0f && at + width > limit) {
            at = 0.0f;
            lines++;
        }
        if (pen != NULL) {
            float top = pen->top + OVERLAY_LINE * (float)(lines - 1);
            overlay_text(pen->overlay, pen->left + at, top, key->label, PEN_BRIGHT);
            overlay_text(pen->overlay, pen->left + at + label + space, top, key->does, PEN_DIM);
        }
        *widest = larger(*widest, at + width);
        at += width + GAP;
    }
    *widest = ceilf(*widest);
    return lines;
}

// The keys stand at the bottom. Returns the place of their panel's top.
static float write_keys(const struct panel *panel, struct overlay *overlay)
{
    float bottom = pen_picture_height(overlay) - PEN_MARGIN, widest;
    if (panel->key_count == 0 || panel->folded)
        return bottom;
    float limit = pen_picture_width(overlay) - 2.0f * (PEN_MARGIN + PEN_PADDING);
    float height = OVERLAY_LINE * (float)lay_keys(panel, NULL, limit, &widest) - 2.0f;
    float top = bottom - height - 2.0f * PEN_PADDING;
    struct pen pen = pen_open(overlay, PEN_MARGIN, top, widest, height);
    lay_keys(panel, &pen, limit, &widest);
    return top - PEN_MARGIN;
}

// ---- Error ----

// Above the keys. A long one is cut where its panel would fill more than half of the picture.
static float write_error(const struct panel *panel, struct overlay *overlay, float bottom)
{
    const char *heading = panel->broken
                              ? "Error: the last good picture stays until the next good save"
                              : "This view can't be shown";
    char line[OVERLAY_TEXT + 1];
    float limit = pen_picture_width(overlay) - 2.0f * (PEN_MARGIN + PEN_PADDING);
    int most = (int)(0.5f * pen_picture_height(overlay) / OVERLAY_LINE), lines = 0;
    if (panel->error == NULL || panel->error[0] == '\0')
        return bottom;
    for (const char *at = panel->error; lines < most && pen_next_line(&at, limit, line);)
        lines++;
    float height = OVERLAY_LINE * ((float)lines + 1.5f) - 2.0f;
    float top = bottom - height - 2.0f * PEN_PADDING;
    struct pen pen = pen_open(overlay, PEN_MARGIN, top, limit, height);
    overlay_box(overlay, PEN_MARGIN, top, 2.0f, height + 2.0f * PEN_PADDING, PEN_BRIGHT);
    pen_write(&pen, heading, PEN_BRIGHT);
    pen_rule(&pen, limit);
    for (const char *at = panel->error; lines > 0 && pen_next_line(&at, limit, line); lines--)
        pen_write(&pen, line, PEN_PLAIN);
    return top - PEN_MARGIN;
}

void panel_gather(const struct panel *panel, struct overlay *overlay, int width, int height,
                  float scale)
{
    overlay_begin(overlay, width, height, scale);
    bool marched = panel->pixel[0] >= 0 && panel->probe != NULL;
    bool refused = panel->pixel[0] >= 0 && !marched && panel->why != NULL;
    float bottom = pair_write(panel->renderer, overlay,
                              write_error(panel, overlay, write_keys(panel, overlay)));
    float right = pen_picture_width(overlay) - PEN_MARGIN;
    if (marched || refused)
        right = inspector_left(overlay, marched) - PEN_MARGIN;
    struct chapter_panel form;
    float room = right - PEN_MARGIN - 2.0f * PEN_PADDING;
    enum shader_view view = panel->renderer->view;
    // A slice's ray runs in the middle of its part of the picture, and nothing covers it.
    float middle = (view == SHADER_PLOT ? 0.5f + 0.5f * PLOT_SHARE : 0.5f) * (float)height;
    float over = form_shows_ray(view) ? inspector_over(overlay, middle) : bottom;
    lay_chapter(panel, room, over < bottom ? over : bottom, &form);
    // Where there is no room for both, the ray that was asked for is what is shown.
    bool chapter = !panel->folded && (form.width <= room || !(marched || refused));
    if (chapter)
        write_chapter(panel, overlay, &form);
    const struct inspector inspector = {.pixel = {panel->pixel[0], panel->pixel[1]},
                                        .probe = marched ? panel->probe : NULL,
                                        .shown = panel->shown,
                                        .view = view,
                                        .middle = middle};
    const struct inspector_room taken = {
        PEN_MARGIN, PEN_MARGIN, PEN_MARGIN + form.width + 2.0f * PEN_PADDING,
        PEN_MARGIN + OVERLAY_LINE * form.lines - 2.0f + 2.0f * PEN_PADDING};
    static const struct inspector_room nothing = {0};
    if (marched && !(form_shows_ray(view) && panel->folded)) {
        const struct inspector_room place =
            inspector_place(overlay, &inspector, chapter ? &taken : &nothing, bottom);
        inspector_march(overlay, &inspector, &place);
    } else if (refused)
        inspector_why(overlay, panel->why);
    if (panel->pixel[0] >= 0)
        inspector_mark(overlay, &inspector);
}
