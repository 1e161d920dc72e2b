#include "picture/inspector.h"

#include <stdio.h>

#include "picture/pen.h"

void inspector_mark(struct overlay *overlay, const int pixel[2])
{
    // Four arms that leave the pixel itself free; a dark edge shows them on a bright picture.
    static const float arms[4][4] = {{-8, 0, 5, 1}, {4, 0, 5, 1}, {0, -8, 1, 5}, {0, 4, 1, 5}};
    float x = ((float)pixel[0] + 0.5f) / overlay->scale - 0.5f;
    float y = ((float)(overlay->height - 1 - pixel[1]) + 0.5f) / overlay->scale - 0.5f;
    for (int i = 0; i < 4; i++) {
        const float *arm = arms[i];
        overlay_box(overlay, x + arm[0] - 1, y + arm[1] - 1, arm[2] + 2, arm[3] + 2, PEN_DARK);
        overlay_box(overlay, x + arm[0], y + arm[1], arm[2], arm[3], PEN_BRIGHT);
    }
}

enum { STEP_COLUMNS = 3 };
// Right edges of the columns.
static const float STEP_RIGHT[STEP_COLUMNS] = {28.0f, 92.0f, 172.0f};
static const float INSPECTOR_WIDTH = 176.0f, WHY_WIDTH = 292.0f;

static void write_step(struct pen *pen, const char *const cell[STEP_COLUMNS],
                       struct overlay_colour colour)
{
    for (int k = 0; k < STEP_COLUMNS; k++)
        overlay_text(pen->overlay, pen->left + STEP_RIGHT[k] - overlay_width(cell[k]), pen->top,
                     cell[k], colour);
    pen->top += OVERLAY_LINE;
}

static void write_steps(struct pen *pen, const struct probe *probe, int most)
{
    int rows = probe_rows(probe), first = rows > most ? rows - most : 0;
    write_step(pen, (const char *const[]){"step", "t", "distance"}, PEN_DIM);
    for (int i = first; i < rows; i++) {
        char step[16], t[32], distance[32];
        snprintf(step, sizeof step, "%d", i);
        snprintf(t, sizeof t, "%.5f", (double)probe->step[i].t);
        snprintf(distance, sizeof distance, "%.6f", (double)probe->step[i].distance);
        write_step(pen, (const char *const[]){step, t, distance},
                   i == rows - 1 ? PEN_BRIGHT : PEN_PLAIN);
    }
}

static void write_outcome(struct pen *pen, const struct probe *probe)
{
    char text[80];
    pen_write(pen, probe_outcome(probe), PEN_BRIGHT);
    int others = probe->all_steps - probe->steps;
    snprintf(text, sizeof text, others > 0 ? "steps %d, of further rays %d" : "steps %d",
             probe->steps, others);
    pen_write(pen, text, PEN_PLAIN);
    snprintf(text, sizeof text, "evaluations of the scene %d", probe->evaluations);
    pen_write(pen, text, PEN_PLAIN);
    snprintf(text, sizeof text, "colour %d, %d, %d", probe->colour[0], probe->colour[1],
             probe->colour[2]);
    pen_write(pen, text, PEN_PLAIN);
}

// Where a panel at the right edge begins.
static float left_of(const struct overlay *overlay, float width)
{
    return pen_picture_width(overlay) - PEN_MARGIN - width - 2.0f * PEN_PADDING;
}

float inspector_left(const struct overlay *overlay, bool marched)
{
    return left_of(overlay, marched ? INSPECTOR_WIDTH : WHY_WIDTH);
}

void inspector_march(struct overlay *overlay, const int pixel[2], const struct probe *probe,
                     float bottom)
{
    // Heading, titles, four lines of the outcome, two rules.
    int most = (int)((bottom - PEN_MARGIN - 2.0f * PEN_PADDING) / OVERLAY_LINE) - 7;
    int rows = probe_rows(probe) < most ? probe_rows(probe) : most;
    if (rows < 1 && probe_rows(probe) > 0)
        return; // the keys take all the room
    rows = rows < 0 ? 0 : rows;
    char heading[80];
    snprintf(heading, sizeof heading, "%s %d, %d",
             rows < probe_rows(probe) ? "last steps of pixel" : "ray of pixel", pixel[0], pixel[1]);
    struct pen pen = pen_open(overlay, inspector_left(overlay, true), PEN_MARGIN, INSPECTOR_WIDTH,
                              OVERLAY_LINE * ((float)rows + 7.0f) - 2.0f);
    pen_write(&pen, heading, PEN_BRIGHT);
    pen_rule(&pen, INSPECTOR_WIDTH);
    write_steps(&pen, probe, rows);
    pen_rule(&pen, INSPECTOR_WIDTH);
    write_outcome(&pen, probe);
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
