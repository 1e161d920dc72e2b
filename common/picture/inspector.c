#include "picture/inspector.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/pen.h"
#include "picture/slice.h"

// Right edges of the columns, units.
enum { STEP_COLUMNS = 3 };
static const float STEP_RIGHT[STEP_COLUMNS] = {28.0f, 92.0f, 172.0f};
static const float INSPECTOR_WIDTH = 176.0f, WHY_WIDTH = 292.0f;

// ---- The size of the table ----

struct table {
    int rows, first; // number of rows, and the index of the first step
    bool titles;     // there are titles above the columns
    bool whole;      // the cost of the ray and its colour are included
    float lines;     // number of lines of the whole table
};

// Return the row of the current step, or -1 if there is none.
static int row_of(const struct inspector *inspector)
{
    int last = probe_rows(inspector->probe) - 1;
    int row = (int)inspector->shown - 1;
    return row > last ? last : row;
}

// If there is little room, the cost and the colour are left out first, then the titles.
static struct table table_of(const struct inspector *inspector, const struct inspector_room *room)
{
    int all = probe_rows(inspector->probe), row = row_of(inspector);
    int lines =
        (int)((room->bottom - room->top - 2.0f * PEN_PADDING + 2.0f) / OVERLAY_LINE + 0.001f);
    struct table table = {.whole = lines >= 7 + (all < 4 ? all : 4)};
    table.titles = table.whole || lines >= 4 + (all < 2 ? all : 2);
    float beside = table.whole ? 7.0f : table.titles ? 4.0f : 2.0f;
    table.rows = lines - (int)beside < all ? lines - (int)beside : all;
    if (table.rows < (all > 0 ? 1 : 0))
        return (struct table){0};
    // The current row is in the middle; if there is none, the last rows are shown.
    table.first = row < 0 ? all - table.rows : row - table.rows / 2;
    table.first = table.first > all - table.rows ? all - table.rows : table.first;
    table.first = table.first < 0 ? 0 : table.first;
    table.lines = (float)table.rows + beside;
    return table;
}

// ---- Marks in the picture ----

// Convert a position from pixels to units, from the picture's top left.
static void position_of(const struct overlay *overlay, const float pixel[2], float position[2])
{
    position[0] = pixel[0] / overlay->scale;
    position[1] = ((float)overlay->height - pixel[1]) / overlay->scale;
}

static void mark_pixel(struct overlay *overlay, const int pixel[2])
{
    // Four arms leave the pixel uncovered; their dark edges make them visible in bright pictures.
    static const float arms[4][4] = {{-8, 0, 5, 1}, {4, 0, 5, 1}, {0, -8, 1, 5}, {0, 4, 1, 5}};
    float x = ((float)pixel[0] + 0.5f) / overlay->scale - 0.5f;
    float y = ((float)(overlay->height - 1 - pixel[1]) + 0.5f) / overlay->scale - 0.5f;
    for (int i = 0; i < 4; i++) {
        const float *arm = arms[i];
        overlay_box(overlay, x + arm[0] - 1, y + arm[1] - 1, arm[2] + 2, arm[3] + 2, PEN_DARK);
        overlay_box(overlay, x + arm[0], y + arm[1], arm[2], arm[3], PEN_BRIGHT);
    }
}

static void edged(struct overlay *overlay, const float from[2], const float to[2], float width,
                  struct overlay_colour colour)
{
    overlay_line(overlay, from, to, width + 2.0f, PEN_DARK);
    overlay_line(overlay, from, to, width, colour);
}

static void mark_arrow(struct overlay *overlay, const float from[2], const float to[2])
{
    float along[2] = {to[0] - from[0], to[1] - from[1]}, length = hypotf(along[0], along[1]);
    float head = fminf(7.0f, 0.5f * length);
    if (length < 4.0f) // too short to be seen
        return;
    edged(overlay, from, to, 2.0f, PEN_HERE);
    for (int side = -1; side <= 1; side += 2) {
        float turned[2] = {-0.87f * along[0] - (float)side * 0.5f * along[1],
                           -0.87f * along[1] + (float)side * 0.5f * along[0]};
        float barb[2] = {to[0] + head / length * turned[0], to[1] + head / length * turned[1]};
        overlay_line(overlay, to, barb, 2.0f, PEN_HERE);
    }
}

// Draw the line of a ray up to a step, with a dot for each step.
static void mark_path(struct overlay *overlay, const struct probe *probe, int last)
{
    float before[2] = {0.0f, 0.0f}, at[2];
    for (int k = 0; k <= last; k++) {
        position_of(overlay, probe->step[k].pixel, at);
        if (probe->step[k].seen && k > 0 && probe->step[k - 1].seen)
            edged(overlay, before, at, 1.0f, PEN_BRIGHT);
        memcpy(before, at, sizeof before);
    }
    for (int k = 0; k <= last; k++) {
        position_of(overlay, probe->step[k].pixel, at);
        if (probe->step[k].seen)
            edged(overlay, at, at, 3.0f, PEN_BRIGHT);
    }
}

void inspector_mark(struct overlay *overlay, const struct inspector *inspector)
{
    const struct probe *probe = inspector->probe;
    int row = probe != NULL ? row_of(inspector) : -1;
    if (shader_shows_ray(inspector->view))
        return;
    if (probe == NULL || !probe->pinned)
        mark_pixel(overlay, inspector->pixel);
    else
        mark_path(overlay, probe, row >= 0 ? row : probe_rows(probe) - 1);
    if (row < 0 || !probe->step[row].seen)
        return;
    float here[2], next[2];
    position_of(overlay, probe->step[row].pixel, here);
    if (row + 1 < probe_rows(probe) && probe->step[row + 1].seen) {
        position_of(overlay, probe->step[row + 1].pixel, next);
        mark_arrow(overlay, here, next);
    }
    edged(overlay, here, here, probe->pinned ? 6.0f : 4.0f, PEN_HERE);
}

// ---- The position of the table ----

float inspector_left(const struct overlay *overlay, bool marched)
{
    float width = marched ? INSPECTOR_WIDTH : WHY_WIDTH;
    return pen_picture_width(overlay) - PEN_MARGIN - width - 2.0f * PEN_PADDING;
}

#define CLEAR 16.0f // units to keep free around a point of the ray and its mark

void inspector_ray(const struct overlay *overlay, float middle, float span[2])
{
    float ray = pen_picture_height(overlay) - middle / overlay->scale;
    float numbers = SLICE_NUMBER * slice_cell(overlay->height) / overlay->scale + 2.0f;
    span[0] = ray - fmaxf(26.0f, numbers);
    span[1] = ray + CLEAR;
}

// Extend the vertical range of a column to a point and its mark, if the point is in the column.
static void extend(float span[2], float left, float right, float x, float y)
{
    if (x < left - CLEAR || x > right + CLEAR)
        return;
    span[0] = fminf(span[0], y - CLEAR);
    span[1] = fmaxf(span[1], y + CLEAR);
}

// Find the vertical range of the ray between the edges of a column: span[0] to span[1]. If the ray
// does not cross the column, span[1] is smaller than span[0].
static void find_span(const struct overlay *overlay, const struct inspector *inspector, float left,
                      float right, float span[2])
{
    const struct probe *probe = inspector->probe;
    const float pixel[2] = {(float)inspector->pixel[0] + 0.5f, (float)inspector->pixel[1] + 0.5f};
    float at[2], before[2] = {0.0f, 0.0f};
    span[0] = pen_picture_height(overlay);
    span[1] = 0.0f;
    if (shader_shows_ray(inspector->view)) {
        inspector_ray(overlay, inspector->middle, span);
        return;
    }
    for (int k = 0; k < probe_rows(probe); k++) {
        if (!probe->step[k].seen)
            continue;
        position_of(overlay, probe->step[k].pixel, at);
        bool joined = k > 0 && probe->step[k - 1].seen;
        for (int i = 1; i <= 32; i++) { // points on the line to this step
            float share = joined ? (float)i / 32.0f : 1.0f;
            extend(span, left, right, before[0] + share * (at[0] - before[0]),
                   before[1] + share * (at[1] - before[1]));
        }
        memcpy(before, at, sizeof before);
    }
    if (probe_rows(probe) == 0) { // the march has no steps
        position_of(overlay, pixel, at);
        extend(span, left, right, at[0], at[1]);
    }
}

struct inspector_room inspector_place(const struct overlay *overlay,
                                      const struct inspector *inspector,
                                      const struct inspector_room *taken, float bottom)
{
    const float width = INSPECTOR_WIDTH + 2.0f * PEN_PADDING;
    float right = inspector_left(overlay, true), beside = taken->right + PEN_MARGIN;
    float under = taken->bottom > 0.0f ? taken->bottom + PEN_MARGIN : PEN_MARGIN;
    float at_left[2], at_right[2], at_middle[2];
    find_span(overlay, inspector, right, right + width, at_right);
    find_span(overlay, inspector, beside, beside + width, at_middle);
    find_span(overlay, inspector, PEN_MARGIN, PEN_MARGIN + width, at_left);
    bool fits = taken->right > 0.0f && beside + width <= pen_picture_width(overlay) - PEN_MARGIN;
    const struct {
        struct inspector_room room;
        bool free;
    } choice[] = {
        {{right, PEN_MARGIN, right + width, bottom}, at_right[0] > at_right[1]},
        {{beside, PEN_MARGIN, beside + width, bottom}, fits && at_middle[0] > at_middle[1]},
        {{right, PEN_MARGIN, right + width, fminf(bottom, at_right[0])}, true},
        {{right, fmaxf(PEN_MARGIN, at_right[1]), right + width, bottom},
         !shader_shows_ray(inspector->view)}, // the slice and plot views have their axis there
        {{PEN_MARGIN, under, PEN_MARGIN + width, bottom}, at_left[0] > at_left[1]},
    };
    int best = 0;
    float most = 0.0f;
    for (int i = 0; i < (int)(sizeof choice / sizeof *choice); i++) {
        float lines = choice[i].free ? table_of(inspector, &choice[i].room).lines : 0.0f;
        if (lines >= 10.0f || lines >= (float)probe_rows(inspector->probe) + 7.0f)
            return choice[i].room;
        if (lines > most) {
            most = lines;
            best = i;
        }
    }
    return most > 0.0f ? choice[best].room : (struct inspector_room){right, 0.0f, right, 0.0f};
}

// ---- The table ----

static void write_step(struct pen *pen, const char *const cell[STEP_COLUMNS],
                       struct overlay_colour colour)
{
    for (int k = 0; k < STEP_COLUMNS; k++)
        overlay_text(pen->overlay, pen->left + STEP_RIGHT[k] - overlay_width(cell[k]), pen->top,
                     cell[k], colour);
    pen->top += OVERLAY_LINE;
}

// The current row has a band and a mark, so that it differs in more than its colour.
static void write_steps(struct pen *pen, const struct inspector *inspector,
                        const struct table *table)
{
    const struct probe *probe = inspector->probe;
    int row = row_of(inspector);
    for (int i = table->first; i < table->first + table->rows; i++) {
        char step[16], t[32], distance[32];
        snprintf(step, sizeof step, "%d", i);
        snprintf(t, sizeof t, "%.5f", (double)probe->step[i].t);
        snprintf(distance, sizeof distance, "%.6f", (double)probe->step[i].distance);
        bool bright = i == row || (row < 0 && i == probe_rows(probe) - 1);
        if (i == row) {
            overlay_box(pen->overlay, pen->left - 3.0f, pen->top - 1.0f, INSPECTOR_WIDTH + 6.0f,
                        OVERLAY_LINE, PEN_BAND);
            overlay_text(pen->overlay, pen->left, pen->top, ">", PEN_BRIGHT);
        }
        write_step(pen, (const char *const[]){step, t, distance}, bright ? PEN_BRIGHT : PEN_PLAIN);
    }
}

static void write_cost(struct pen *pen, const struct probe *probe)
{
    char text[80];
    int others = probe->all_steps - probe->steps;
    snprintf(text, sizeof text, others > 0 ? "steps %d (further rays: %d)" : "steps %d",
             probe->steps, others);
    pen_write(pen, text, PEN_PLAIN);
    snprintf(text, sizeof text, "evaluations of the scene %d", probe->evaluations);
    pen_write(pen, text, PEN_PLAIN);
    snprintf(text, sizeof text, "colour %d, %d, %d", probe->colour[0], probe->colour[1],
             probe->colour[2]);
    pen_write(pen, text, PEN_PLAIN);
}

// Write the heading, which names the ray and the current step.
static void heading_of(const struct inspector *inspector, const struct table *table, char *text,
                       size_t size)
{
    int all = probe_rows(inspector->probe), row = row_of(inspector);
    const char *what = table->rows < all && row < 0 ? "last steps of " : "ray of ";
    char side[16] = "", step[40] = "";
    if (inspector->side != NULL)
        snprintf(side, sizeof side, " (%s)", inspector->side);
    if (row >= 0)
        snprintf(step, sizeof step, ": step %d, last %d", row, all - 1);
    if (row >= 0 && inspector->side != NULL)
        what = ""; // the heading would be too long otherwise
    snprintf(text, size, "%spixel %d, %d%s%s", what, inspector->pixel[0], inspector->pixel[1], side,
             step);
}

void inspector_march(struct overlay *overlay, const struct inspector *inspector,
                     const struct inspector_room *room, struct inspector_table *drawn)
{
    struct table table = table_of(inspector, room);
    char heading[80];
    if (table.lines < 1.0f)
        return;
    heading_of(inspector, &table, heading, sizeof heading);
    struct pen pen = pen_open(overlay, room->left, room->top, INSPECTOR_WIDTH,
                              OVERLAY_LINE * table.lines - 2.0f);
    pen_write(&pen, heading, PEN_BRIGHT);
    if (table.titles) {
        pen_rule(&pen, INSPECTOR_WIDTH);
        write_step(&pen, (const char *const[]){"step", "t", "distance"}, PEN_DIM);
    }
    if (drawn != NULL)
        *drawn = (struct inspector_table){room->left,
                                          room->top,
                                          room->left + INSPECTOR_WIDTH + 2.0f * PEN_PADDING,
                                          room->top + OVERLAY_LINE * table.lines - 2.0f +
                                              2.0f * PEN_PADDING,
                                          pen.top - 1.0f,
                                          table.first,
                                          table.rows};
    write_steps(&pen, inspector, &table);
    if (table.titles)
        pen_rule(&pen, INSPECTOR_WIDTH);
    pen_write(&pen, probe_outcome(inspector->probe), PEN_BRIGHT);
    if (table.whole)
        write_cost(&pen, inspector->probe);
}

bool inspector_table_at(const struct inspector_table *table, const float unit[2], int *step)
{
    int line = (int)floorf((unit[1] - table->row) / OVERLAY_LINE);
    *step = line >= 0 && line < table->rows ? table->first + line : -1;
    return unit[0] >= table->left && unit[0] < table->right && unit[1] >= table->top &&
           unit[1] < table->bottom;
}

void inspector_why(struct overlay *overlay, const char *why)
{
    char line[OVERLAY_TEXT + 1];
    int lines = 0;
    for (const char *at = why; pen_next_line(&at, WHY_WIDTH, line);)
        lines++;
    float left = inspector_left(overlay, false);
    struct pen pen =
        pen_open(overlay, left, PEN_MARGIN, WHY_WIDTH, OVERLAY_LINE * (float)lines - 2.0f);
    for (const char *at = why; pen_next_line(&at, WHY_WIDTH, line);)
        pen_write(&pen, line, PEN_PLAIN);
}
