#include "picture/panel_rows.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "picture/pair.h"
#include "picture/pen.h"

#define MARK          14.0f // the room of the mark that folds
#define WIDEST_COLOUR "0.000,0.000,0.000"

static float larger(float a, float b)
{
    return a > b ? a : b;
}

// ---- Building ----

static struct panel_row *add(struct panel_rows *rows, enum panel_row_kind kind, const char *text)
{
    rows->row = memory_row(rows->row, rows->count, sizeof *rows->row);
    struct panel_row *row = &rows->row[rows->count++];
    *row = (struct panel_row){.kind = kind, .parameter = -1, .part = -1, .place = -1.0};
    snprintf(row->cell[0], PANEL_CELL, "%s", text);
    return row;
}

static void status_text(const struct panel *panel, bool rated, char *text, size_t size)
{
    snprintf(text, size, "view: %s", shader_view_name(panel->renderer->view));
    size_t used = strlen(text);
    if (rated && panel->rate > 0.0)
        snprintf(text + used, size - used, "    %.0f fps, %.1f ms", panel->rate,
                 panel->milliseconds);
    used = strlen(text);
    if (panel->timed)
        snprintf(text + used, size - used, "    time %.1f s", panel->time);
    used = strlen(text);
    // Where the time drives the hour of a chapter's sky.
    const struct parameters *all = &panel->renderer->parameters;
    const struct parameter *start = parameters_find(all, "timeOfDay");
    const struct parameter *speed = parameters_find(all, "hoursPerSecond");
    if (panel->timed && start != NULL && speed != NULL) {
        double hour = start->value[0] + speed->value[0] * panel->time;
        int minute = (int)floor(60.0 * (hour - 24.0 * floor(hour / 24.0)));
        snprintf(text + used, size - used, ", hour %02d:%02d", minute / 60, minute % 60);
        used = strlen(text);
    }
    if (panel->paused)
        snprintf(text + used, size - used, "    paused");
}

// Of two slices or plots: whose march is where.
static void marches_text(const struct panel *panel, char *text, size_t size)
{
    bool two = panel->renderer->pair != NULL && form_shows_ray(panel->renderer->view);
    bool table = panel->pixel[0] >= 0 && panel->probe != NULL;
    const char *side = panel->side != NULL ? panel->side : "";
    snprintf(text, size, "%s%s%s", two ? "each side of the line: its own march" : "",
             two && table ? "; table: " : "", two && table ? side : "");
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

static void textures_text(const struct panel *panel, char text[PANEL_CELL])
{
    const struct textures *textures = &panel->renderer->textures;
    text[0] = '\0';
    for (int i = 0; i < textures->count; i++) {
        size_t used = strlen(text);
        snprintf(text + used, PANEL_CELL - used, "%s%s",
                 i > 0 ? ", " : "textures: ", textures->item[i].name);
    }
}

// Name, value, range and unit of a parameter.
static void fill_cells(const struct panel *panel, const struct parameter *parameter,
                       char cell[PANEL_COLUMNS][PANEL_CELL])
{
    pair_parameter_name(panel->renderer, parameter, cell[0], PANEL_CELL);
    parameter_value_text(parameter, cell[1], PANEL_CELL);
    parameter_range_text(parameter, cell[2], PANEL_CELL);
    snprintf(cell[3], PANEL_CELL, "%s", parameter->unit);
}

static void detail_text(const struct parameter *parameter, char text[PANEL_CELL])
{
    char range[80];
    parameter_range_text(parameter, range, sizeof range);
    snprintf(text, PANEL_CELL, "%s %s", range, parameter->unit);
}

// The chosen vector is followed by its parts.
static void add_parts(struct panel_rows *rows, const struct parameter *parameter, int index)
{
    const char *names = parameter_is_colour(parameter) ? "rgba" : "xyzw";
    for (int k = 0; k < parameter->components && parameter->components > 1; k++) {
        char name[8];
        snprintf(name, sizeof name, "   %c", names[k]);
        struct panel_row *row = add(rows, PANEL_ROW_PART, name);
        number_text(parameter->value[k], row->cell[1], NUMBER_SIZE);
        row->parameter = index;
        row->part = k;
        row->chosen = true;
        row->place = parameter_place(parameter, k);
    }
}

// A colour shows itself to whoever has a pointer.
static bool has_swatch(const struct panel *panel, const struct parameter *parameter)
{
    return panel->rows != NULL && parameter_is_colour(parameter);
}

static void add_parameter(struct panel_rows *rows, const struct panel *panel, int index)
{
    const struct parameter *parameter = pair_parameter(panel->renderer, index);
    struct panel_row *row = add(rows, PANEL_ROW_PARAMETER, "");
    bool chosen = panel->chosen != NULL && parameter == panel->chosen;
    fill_cells(panel, parameter, row->cell);
    row->parameter = index;
    row->chosen = chosen;
    row->place = parameter->components == 1 ? parameter_place(parameter, 0) : -1.0;
    if (has_swatch(panel, parameter)) {
        row->swatch = PANEL_GAP + rows->column[0] + PANEL_GAP;
        for (int k = 0; k < 3; k++)
            row->share[k] = parameter_place(parameter, k);
    }
    if (!chosen)
        return;
    add_parts(rows, parameter, index);
    if (!rows->ranges) {
        row = add(rows, PANEL_ROW_DETAIL, "");
        detail_text(parameter, row->cell[0]);
        row->parameter = index;
        row->chosen = true;
    }
}

// Of the parameters' rows, from first to behind last, keep as many as there is room for: the chosen
// one stays in sight with all that belongs to it. The last place says which are shown.
static void cut(struct panel_rows *rows, int first, int room, int parameters)
{
    int count = rows->count - first, top = count, behind = 0, from = 0, to = -1;
    if (count <= room)
        return;
    room = room > 1 ? room - 1 : 0;
    for (int i = 0; i < count; i++)
        if (rows->row[first + i].chosen) {
            top = i < top ? i : top;
            behind = i + 1;
        }
    int begin = behind <= room ? 0 : behind - room;
    begin = begin > top ? top : begin;
    memmove(&rows->row[first], &rows->row[first + begin], (size_t)room * sizeof *rows->row);
    rows->count = first + room;
    for (int i = first; i < rows->count; i++) {
        from = to < 0 ? rows->row[i].parameter + 1 : from;
        to = rows->row[i].parameter + 1;
    }
    char text[64];
    if (to < 0)
        snprintf(text, sizeof text, "%d parameter%s", parameters, parameters == 1 ? "" : "s");
    else
        snprintf(text, sizeof text, "%d to %d of %d", from, to, parameters);
    add(rows, PANEL_ROW_TEXT, text);
}

// ---- Measuring ----

static float height_of(enum panel_row_kind kind)
{
    return kind == PANEL_ROW_RULE ? 0.5f * OVERLAY_LINE : OVERLAY_LINE;
}

static float height_from(const struct panel_rows *rows, int first)
{
    float height = 0.0f;
    for (int i = first; i < rows->count; i++)
        height += height_of(rows->row[i].kind);
    return height;
}

// The width of the table of the first columns, or of the widest detail below one of its lines.
static float measure_table(const struct panel *panel, int columns, float width[PANEL_COLUMNS])
{
    const struct parameter *parameter;
    char cell[PANEL_COLUMNS][PANEL_CELL], detail[PANEL_CELL];
    float sum = 0.0f, widest = 0.0f;
    memset(width, 0, PANEL_COLUMNS * sizeof *width);
    for (int i = 0; (parameter = pair_parameter(panel->renderer, i)) != NULL; i++) {
        sum = PANEL_GAP;
        fill_cells(panel, parameter, cell);
        detail_text(parameter, detail);
        widest = larger(widest, 2.0f * PANEL_GAP + overlay_width(detail));
        for (int k = 0; k < columns; k++)
            width[k] = larger(width[k], overlay_width(cell[k]));
        // Its numbers are dragged: the panel does not tremble with them.
        if (has_swatch(panel, parameter))
            width[1] =
                larger(width[1], PANEL_SWATCH + 4.0f +
                                     larger(overlay_width(cell[1]), overlay_width(WIDEST_COLOUR)));
    }
    for (int k = 0; k < columns; k++)
        sum += width[k] + (k > 0 && width[k] > 0.0f ? PANEL_GAP : 0.0f);
    return columns < PANEL_COLUMNS ? larger(sum, widest) : sum;
}

static float in_steps(float width)
{
    return 20.0f * ceilf(width / 20.0f);
}

// The width of the texts, in steps, so that a panel does not tremble with its numbers.
static float measure_texts(const struct panel_rows *rows)
{
    float texts = 0.0f;
    for (int i = 0; i < rows->count; i++) {
        const struct panel_row *row = &rows->row[i];
        float mark = row->kind == PANEL_ROW_TITLE && row->cell[1][0] != '\0' ? MARK : 0.0f;
        if (row->kind == PANEL_ROW_TITLE || row->kind == PANEL_ROW_TEXT)
            texts = larger(texts, overlay_width(row->cell[0]) + mark);
    }
    return in_steps(texts);
}

void panel_rows_move(struct panel_rows *rows, float left, float top)
{
    float at = top + PEN_PADDING + 1.0f;
    rows->left = left;
    rows->top = top;
    for (int i = 0; i < rows->count; i++) {
        struct panel_row *row = &rows->row[i];
        row->left = left + PEN_PADDING;
        row->top = at;
        row->width = rows->width - 2.0f * PEN_PADDING;
        row->height = height_of(row->kind);
        at += row->height;
    }
}

// What stands below the parameters.
static void add_last(struct panel_rows *rows, const char *last, const char *textures)
{
    if (textures[0] != '\0')
        add(rows, PANEL_ROW_TEXT, textures);
    if (last[0] != '\0') {
        add(rows, PANEL_ROW_RULE, "");
        add(rows, PANEL_ROW_TEXT, last);
    }
}

static float height_of_panel(const struct panel_rows *rows)
{
    return height_from(rows, 0) - 2.0f + 2.0f * PEN_PADDING;
}

// Where it would still be too high, its last rows are left out, and what no row is below; the title
// stays.
static void leave_out(struct panel_rows *rows, float bottom)
{
    while (rows->count > 1 && (PEN_MARGIN + height_of_panel(rows) > bottom ||
                               rows->row[rows->count - 1].kind == PANEL_ROW_RULE))
        rows->count--;
}

void panel_rows_build(struct panel_rows *rows, const struct panel *panel, float limit, float bottom)
{
    int parameters = pair_parameter_count(panel->renderer);
    char text[PANEL_CELL], last[PANEL_CELL], textures[PANEL_CELL] = "";
    float table = 0.0f;
    rows->count = 0;
    struct panel_row *title = add(rows, PANEL_ROW_TITLE, panel->title);
    if (panel->rows != NULL)
        snprintf(title->cell[1], PANEL_CELL, "%s", panel->rolled ? "▸" : "▾");
    if (!panel->rolled) {
        status_text(panel, true, text, sizeof text);
        if (in_steps(overlay_width(text)) > limit)
            status_text(panel, false, text, sizeof text);
        last_text(panel, last, sizeof last);
        table = measure_table(panel, PANEL_COLUMNS, rows->column);
        rows->ranges = panel->chosen == NULL || (panel->ranges && table <= limit);
        if (!rows->ranges)
            table = measure_table(panel, 2, rows->column);
        if (rows->ranges)
            textures_text(panel, textures);
        add(rows, PANEL_ROW_TEXT, text);
        marches_text(panel, text, sizeof text);
        if (text[0] != '\0' && in_steps(overlay_width(text)) <= limit)
            add(rows, PANEL_ROW_TEXT, text);
        int above = rows->count;
        // What stands below is measured first: the parameters have the room that is left.
        add_last(rows, last, textures);
        float room = bottom - PEN_MARGIN - 2.0f * PEN_PADDING + 2.0f - height_from(rows, 0);
        rows->count = above;
        if (parameters > 0) {
            add(rows, PANEL_ROW_RULE, "");
            room -= height_of(PANEL_ROW_RULE);
        }
        int first = rows->count;
        for (int i = 0; i < parameters; i++)
            add_parameter(rows, panel, i);
        cut(rows, first, (int)(room / OVERLAY_LINE), parameters);
        add_last(rows, last, textures);
    }
    leave_out(rows, bottom);
    rows->width = ceilf(larger(measure_texts(rows), table)) + 2.0f * PEN_PADDING;
    rows->height = height_of_panel(rows);
    panel_rows_move(rows, PEN_MARGIN, PEN_MARGIN);
}

// ---- The pointer ----

bool panel_rows_hold(const struct panel_rows *rows, float x, float y)
{
    return rows->count > 0 && x >= rows->left && x < rows->left + rows->width && y >= rows->top &&
           y < rows->top + rows->height;
}

const struct panel_row *panel_rows_at(const struct panel_rows *rows, float x, float y)
{
    // A row's letters stand in its middle: it is touched from a little above them.
    for (int i = 0; i < rows->count && panel_rows_hold(rows, x, y); i++)
        if (y >= rows->row[i].top - 2.0f && y < rows->row[i].top - 2.0f + rows->row[i].height)
            return &rows->row[i];
    return NULL;
}

bool panel_row_is_mark(const struct panel_row *row, float x)
{
    return row->kind == PANEL_ROW_TITLE && x >= row->left + row->width - MARK;
}

bool panel_row_is_swatch(const struct panel_row *row, float x)
{
    float from = row->left + row->swatch;
    return row->swatch > 0.0f && x >= from - 2.0f && x < from + PANEL_SWATCH + 2.0f;
}

void panel_rows_free(struct panel_rows *rows)
{
    free(rows->row);
    *rows = (struct panel_rows){0};
}
