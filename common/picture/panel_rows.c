#include "picture/panel_rows.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "picture/comparison.h"
#include "picture/pen.h"

#define MARK          14.0f // width of the mark that collapses the panel
#define WIDEST_COLOUR "0.000,0.000,0.000"

// ---- Building ----

static struct panel_row *add(struct panel_rows *rows, enum panel_row_kind kind, const char *text)
{
    rows->row = memory_row(rows->row, rows->count, sizeof *rows->row);
    struct panel_row *row = &rows->row[rows->count++];
    *row = (struct panel_row){.kind = kind, .parameter = -1, .part = -1, .fraction = -1.0};
    snprintf(row->cell[0], PANEL_CELL, "%s", text);
    return row;
}

// Append the hour of the day if there are parameters for the hour at the start and for its speed.
// The hour follows from these parameters and the picture's time.
static void add_hour(const struct panel *panel, char text[PANEL_CELL])
{
    const struct parameters *all = &panel->renderer->parameters;
    const struct parameter *start = NULL, *speed = NULL;
    for (const struct parameter *p = all->item; p < all->item + all->count; p++) {
        start = parameter_is_hour(p) ? p : start;
        speed = strcmp(p->unit, "hours per second") == 0 ? p : speed;
    }
    if (start == NULL || speed == NULL)
        return;
    double hour = start->value[0] + speed->value[0] * panel->time;
    int minute = (int)floor(60.0 * (hour - 24.0 * floor(hour / 24.0)));
    memory_append(text, PANEL_CELL, ", hour %02d:%02d", minute / 60, minute % 60);
}

static void status_text(const struct panel *panel, bool rated, bool paused, char text[PANEL_CELL])
{
    snprintf(text, PANEL_CELL, "view: %s", shader_view_name(panel->renderer->view));
    if (paused) // there is no rate
        memory_append(text, PANEL_CELL, "    paused");
    else if (rated && panel->milliseconds > 0.0 && panel->rate > 0.0)
        memory_append(text, PANEL_CELL, "    %.*f fps", panel->rate < 9.95 ? 1 : 0, panel->rate);
    else if (rated && panel->milliseconds > 0.0)
        memory_append(text, PANEL_CELL, "    drawn in %.1f ms", panel->milliseconds);
    if (panel->averaged > 0)
        memory_append(text, PANEL_CELL, "    mean of %d frame%s", panel->averaged,
                      panel->averaged > 1 ? "s" : "");
    else if (panel->timed) {
        memory_append(text, PANEL_CELL, "    time %.1f s", panel->time);
        add_hour(panel, text);
    }
}

// Add the list of views, with the current one selected.
static void add_views(struct panel_rows *rows, const struct panel *panel)
{
    for (int i = 0; panel->views && i < SHADER_VIEW_COUNT; i++) {
        struct panel_row *row = add(rows, PANEL_ROW_VIEW, shader_view_name((enum shader_view)i));
        row->part = i;
        row->selected = i == (int)panel->renderer->view;
    }
}

static void add_buttons(struct panel_rows *rows, const struct panel *panel)
{
    bool steps = panel->renderer->fragment.marches;
    if (!panel->buttons)
        return;
    add(rows, PANEL_ROW_RULE, "");
    struct panel_row *row = add(rows, PANEL_ROW_BUTTONS,
                                panel->paused  ? "resume"
                                : panel->timed ? "pause"
                                               : "");
    snprintf(row->cell[PANEL_STEP_BACK], PANEL_CELL, "%s", steps ? "step back" : "");
    snprintf(row->cell[PANEL_STEP_ON], PANEL_CELL, "%s", steps ? "step on" : "");
    snprintf(row->cell[PANEL_HIDE], PANEL_CELL, "hide");
}

// For two slices or plots, write that each side shows its own march, and which side's march is in
// the table.
static void marches_text(const struct panel *panel, char text[PANEL_CELL])
{
    bool two = panel->renderer->comparison != NULL && shader_shows_ray(panel->renderer->view);
    bool table = panel->pixel[0] >= 0 && panel->probe != NULL;
    const char *side = panel->side != NULL ? panel->side : "";
    snprintf(text, PANEL_CELL, "%s%s%s", two ? "each side shows its own march" : "",
             two && table ? "; table: " : "", two && table ? side : "");
}

// Add the last rows: the textures, the buttons, the hint, and the resolution while it is reduced.
static void add_last(struct panel_rows *rows, const struct panel *panel)
{
    const struct textures *textures = &panel->renderer->textures;
    bool coarse = panel->resolution > 0 && panel->resolution < 100;
    char text[PANEL_CELL] = "";
    for (int i = 0; rows->ranges && i < textures->count; i++)
        memory_append(text, sizeof text, "%s%s",
                      i > 0 ? ", " : "textures: ", textures->item[i].name);
    if (text[0] != '\0')
        add(rows, PANEL_ROW_TEXT, text);
    add_buttons(rows, panel);
    snprintf(text, sizeof text, "%s", panel->hint != NULL ? panel->hint : "");
    // Whether the picture is sharpened or moves, the row has about the same width.
    if (coarse && panel->sharp < 100)
        memory_append(
            text, sizeof text, panel->sharp > 0 ? "%ssharpening: %d %%" : "%s%d %% resolution",
            text[0] != '\0' ? "    " : "", panel->sharp > 0 ? panel->sharp : panel->resolution);
    if (text[0] == '\0')
        return;
    if (!panel->buttons)
        add(rows, PANEL_ROW_RULE, "");
    add(rows, PANEL_ROW_TEXT, text);
}

// Fill in the name, value, range and unit of a parameter.
static void fill_cells(const struct panel *panel, const struct parameter *parameter,
                       char cell[PANEL_COLUMNS][PANEL_CELL])
{
    comparison_parameter_name(panel->renderer, parameter, cell[0], PANEL_CELL);
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

// Add the components of a vector.
static void add_parts(struct panel_rows *rows, const struct panel *panel,
                      const struct parameter *parameter, int index, bool selected)
{
    const char *names = parameter_is_colour(parameter) ? "rgba" : "xyzw";
    for (int k = 0; k < parameter->components && parameter->components > 1; k++) {
        const char name[] = {' ', ' ', ' ', names[k], '\0'};
        struct panel_row *row = add(rows, PANEL_ROW_PART, name);
        number_text(parameter->value[k], row->cell[1], NUMBER_SIZE);
        row->parameter = index;
        row->part = k;
        row->selected = selected;
        row->current = selected && k == panel->selected_part;
        row->fraction = parameter_fraction(parameter, k);
    }
}

// A colour has a swatch only if there is a pointer that can click on it.
static bool has_swatch(const struct panel *panel, const struct parameter *parameter)
{
    return panel->rows != NULL && parameter_is_colour(parameter);
}

static void add_parameter(struct panel_rows *rows, const struct panel *panel, int index)
{
    const struct parameter *parameter = comparison_parameter(panel->renderer, index);
    struct panel_row *row = add(rows, PANEL_ROW_PARAMETER, "");
    fill_cells(panel, parameter, row->cell);
    row->parameter = index;
    row->selected = parameter == panel->selected;
    row->current = row->selected && (parameter->components == 1 || panel->selected_part < 0);
    row->fraction = parameter->components == 1 ? parameter_fraction(parameter, 0) : -1.0;
    if (has_swatch(panel, parameter)) {
        row->swatch = PANEL_GAP + rows->column[0] + PANEL_GAP;
        for (int k = 0; k < 3; k++)
            row->share[k] = parameter_fraction(parameter, k);
    }
    bool selected = row->selected;
    if (!selected && (index >= 64 || (panel->open >> index & 1) == 0))
        return;
    add_parts(rows, panel, parameter, index, selected);
    if (!rows->ranges) {
        row = add(rows, PANEL_ROW_DETAIL, "");
        detail_text(parameter, row->cell[0]);
        row->parameter = index;
        row->selected = selected;
    }
}

// ---- Measuring ----

static float height_of(enum panel_row_kind kind)
{
    return kind == PANEL_ROW_RULE ? 0.5f * OVERLAY_LINE : OVERLAY_LINE;
}

static float height_of_panel(const struct panel_rows *rows)
{
    float height = 2.0f * PEN_PADDING - 2.0f;
    for (int i = 0; i < rows->count; i++)
        height += height_of(rows->row[i].kind);
    return height;
}

// Keep as many of the parameters' rows, [first, end), as fit. The selected parameter stays visible,
// with all its rows if there is room; but if the panel is still, no row moves as long as the first
// of them is visible. If rows are left out, one more row says which parameters are shown.
//   parameters  the total number of parameters
static void cut(struct panel_rows *rows, const struct panel *panel, int first, int end,
                float bottom, int parameters)
{
    int count = end - first, top = count, behind = 0, from = 0, to = -1, before = 0;
    float above = PEN_MARGIN + height_of_panel(rows) - OVERLAY_LINE * (float)count;
    int room = (int)((bottom - above) / OVERLAY_LINE);
    if (count <= room || count == 0)
        return;
    room = room > 1 ? room - 1 : 0;
    for (int i = 0; i < count; i++)
        if (rows->row[first + i].selected) {
            top = i < top ? i : top;
            behind = i + 1;
        }
    while (before < count - room && rows->row[first + before].parameter < rows->from)
        before++;
    int begin = behind <= room ? 0 : behind - room;
    begin = begin > top ? top : begin;
    begin = panel->still && top >= before && top < before + room ? before : begin;
    rows->from = rows->row[first + begin].parameter;
    struct panel_row *kept = &rows->row[first];
    memmove(kept, kept + begin, (size_t)room * sizeof *kept);
    for (int i = 0; i < room; i++) {
        from = to < 0 ? kept[i].parameter + 1 : from;
        to = kept[i].parameter + 1;
    }
    kept[room] = (struct panel_row){PANEL_ROW_MORE, .parameter = -1, .part = to, .fraction = -1.0};
    if (to < 0)
        snprintf(kept[room].cell[0], PANEL_CELL, "no room for %d parameter%s", parameters,
                 parameters == 1 ? "" : "s");
    else
        snprintf(kept[room].cell[0], PANEL_CELL, "%d to %d of %d%s", from, to, parameters,
                 panel->rows != NULL ? " ▾" : "");
    memmove(&kept[room + 1], &rows->row[end], (size_t)(rows->count - end) * sizeof *kept);
    rows->count -= count - room - 1;
}

// Measure the table's first columns. Returns the width of the table, including the details below
// its rows unless all columns are shown.
static float measure_table(const struct panel *panel, int columns, float width[PANEL_COLUMNS])
{
    const struct parameter *parameter;
    char cell[PANEL_COLUMNS][PANEL_CELL], detail[PANEL_CELL];
    float sum = 0.0f, widest = 0.0f;
    memset(width, 0, PANEL_COLUMNS * sizeof *width);
    for (int i = 0; (parameter = comparison_parameter(panel->renderer, i)) != NULL; i++) {
        sum = PANEL_GAP;
        fill_cells(panel, parameter, cell);
        detail_text(parameter, detail);
        widest = fmaxf(widest, 2.0f * PANEL_GAP + overlay_width(detail));
        for (int k = 0; k < columns; k++)
            width[k] = fmaxf(width[k], overlay_width(cell[k]));
        // Dragging changes a colour's numbers, but must not change the panel's width.
        if (has_swatch(panel, parameter))
            width[1] =
                fmaxf(width[1], PANEL_SWATCH + 4.0f +
                                    fmaxf(overlay_width(cell[1]), overlay_width(WIDEST_COLOUR)));
    }
    for (int k = 0; k < columns; k++)
        sum += width[k] + (k > 0 && width[k] > 0.0f ? PANEL_GAP : 0.0f);
    return columns < PANEL_COLUMNS ? fmaxf(sum, widest) : sum;
}

static float in_steps(float width)
{
    return 20.0f * ceilf(width / 20.0f);
}

// Return the width of the text and the buttons, rounded up to a multiple of 20 units, so that the
// panel keeps its width when a number changes, and does not become wider when the picture is
// paused.
static float measure_texts(const struct panel_rows *rows)
{
    float texts = 0.0f;
    for (int i = 0; i < rows->count; i++) {
        const struct panel_row *row = &rows->row[i];
        bool text = row->kind == PANEL_ROW_TITLE || row->kind == PANEL_ROW_STATUS ||
                    row->kind == PANEL_ROW_TEXT || row->kind == PANEL_ROW_MORE;
        if (row->kind == PANEL_ROW_BUTTONS)
            texts = fmaxf(texts,
                          panel_row_button_left(row, PANEL_COLUMNS) - PANEL_GAP +
                              (row->cell[PANEL_PAUSE][0] != '\0'
                                   ? overlay_width("resume") - overlay_width(row->cell[PANEL_PAUSE])
                                   : 0.0f));
        if (row->kind == PANEL_ROW_STATUS)
            texts = fmaxf(texts, overlay_width(row->cell[PANEL_WIDEST]) + MARK);
        if (text)
            texts =
                fmaxf(texts, overlay_width(row->cell[0]) + (row->cell[1][0] != '\0' ? MARK : 0.0f));
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

// Add the rows below the title. Returns the width of the table.
static float add_rows(struct panel_rows *rows, const struct panel *panel, float limit, float bottom)
{
    int parameters = comparison_parameter_count(panel->renderer);
    char text[PANEL_CELL];
    float table = measure_table(panel, PANEL_COLUMNS, rows->column);
    rows->ranges = panel->selected == NULL || (panel->ranges && table <= limit);
    if (!rows->ranges)
        table = measure_table(panel, 2, rows->column);
    status_text(panel, true, panel->paused, text);
    if (in_steps(overlay_width(text) + MARK) > limit)
        status_text(panel, false, panel->paused, text);
    struct panel_row *status = add(rows, PANEL_ROW_STATUS, text);
    if (panel->rows != NULL && panel->choice)
        snprintf(status->cell[1], PANEL_CELL, "%s", panel->views ? "▾" : "▸");
    status_text(panel, true, true, text);
    if (in_steps(overlay_width(text) + MARK) <= limit)
        snprintf(status->cell[PANEL_WIDEST], PANEL_CELL, "%s", text);
    add_views(rows, panel);
    marches_text(panel, text);
    if (text[0] != '\0' && in_steps(overlay_width(text)) <= limit)
        add(rows, PANEL_ROW_TEXT, text);
    if (parameters > 0)
        add(rows, PANEL_ROW_RULE, "");
    int first = rows->count;
    for (int i = 0; i < parameters; i++)
        add_parameter(rows, panel, i);
    int end = rows->count;
    add_last(rows, panel);
    cut(rows, panel, first, end, bottom, parameters);
    return table;
}

void panel_rows_build(struct panel_rows *rows, const struct panel *panel, float limit, float bottom)
{
    bool closed = panel->rolled || panel->folded;
    rows->count = 0;
    struct panel_row *title = add(rows, PANEL_ROW_TITLE, panel->title);
    if (panel->rows != NULL)
        snprintf(title->cell[1], PANEL_CELL, "%s", closed ? "▸" : "▾");
    float table = closed ? 0.0f : add_rows(rows, panel, limit, bottom);
    // A panel that is still too high loses its last rows, and a rule with nothing below it.
    while (rows->count > 1 && (PEN_MARGIN + height_of_panel(rows) > bottom ||
                               rows->row[rows->count - 1].kind == PANEL_ROW_RULE))
        rows->count--;
    rows->width = ceilf(fmaxf(measure_texts(rows), table)) + 2.0f * PEN_PADDING;
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
    // A row's letters are in the middle of the row, so the row begins a little above them.
    for (int i = 0; i < rows->count && panel_rows_hold(rows, x, y); i++)
        if (y >= rows->row[i].top - 2.0f && y < rows->row[i].top - 2.0f + rows->row[i].height)
            return &rows->row[i];
    return NULL;
}

float panel_row_button_left(const struct panel_row *row, int button)
{
    float left = 0.0f;
    for (int i = 0; i < button; i++)
        left += row->cell[i][0] != '\0' ? overlay_width(row->cell[i]) + PANEL_GAP : 0.0f;
    return left;
}

int panel_row_button(const struct panel_row *row, float x)
{
    float half = 0.5f * PANEL_GAP;
    for (int i = 0; i < PANEL_COLUMNS && row->kind == PANEL_ROW_BUTTONS; i++)
        if (x >= row->left + panel_row_button_left(row, i) - half &&
            x < row->left + panel_row_button_left(row, i + 1) - half)
            return i;
    return -1;
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
