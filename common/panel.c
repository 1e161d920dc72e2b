#include "panel.h"

#include <stdio.h>
#include <string.h>

#include "probe.h"

// Units of the overlay.
#define MARGIN  8.0f // of a panel from the picture's edge
#define PADDING 7.0f // of the text from the panel's edge
#define GAP     12.0f
#define LINE    OVERLAY_LINE

static const struct overlay_colour BACKGROUND = {{12, 14, 18, 212}};
static const struct overlay_colour BAND = {{255, 255, 255, 38}};
static const struct overlay_colour RULE = {{255, 255, 255, 46}};
static const struct overlay_colour BRIGHT = {{250, 250, 250, 255}};
static const struct overlay_colour PLAIN = {{218, 221, 226, 255}};
static const struct overlay_colour DIM = {{160, 167, 178, 255}};
static const struct overlay_colour DARK = {{0, 0, 0, 200}};

// Where the next line of a panel goes, in units.
struct pen {
    struct overlay *overlay;
    float left, top;
};

static float picture_width(const struct overlay *overlay)
{
    return (float)overlay->width / overlay->scale;
}

static float picture_height(const struct overlay *overlay)
{
    return (float)overlay->height / overlay->scale;
}

// A panel's background; the pen stands at its first line.
static struct pen open_panel(struct overlay *overlay, float left, float top, float width,
                             float height)
{
    overlay_box(overlay, left, top, width + 2.0f * PADDING, height + 2.0f * PADDING, BACKGROUND);
    return (struct pen){overlay, left + PADDING, top + PADDING + 1.0f};
}

static void write_line(struct pen *pen, const char *text, struct overlay_colour colour)
{
    overlay_text(pen->overlay, pen->left, pen->top, text, colour);
    pen->top += LINE;
}

static void rule(struct pen *pen, float width)
{
    overlay_box(pen->overlay, pen->left, pen->top + 1.0f, width, 1.0f, RULE);
    pen->top += 0.5f * LINE;
}

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

static float measure_columns(const struct parameters *parameters, float width[COLUMNS])
{
    char cell[COLUMNS][CELL];
    float sum = 0.0f;
    for (int i = 0; i < parameters->count; i++) {
        fill_cells(&parameters->item[i], cell);
        for (int k = 0; k < COLUMNS; k++)
            width[k] = larger(width[k], overlay_width(cell[k]));
    }
    for (int k = 0; k < COLUMNS; k++)
        sum += width[k] + (k > 0 && width[k] > 0.0f ? GAP : 0.0f);
    return parameters->count > 0 ? sum + GAP : 0.0f;
}

// The chosen parameter has a mark and a band, so that no colour has to tell it.
static void write_parameter(struct pen *pen, const struct parameter *parameter, bool chosen,
                            const float width[COLUMNS], float whole)
{
    static const struct overlay_colour *const colours[COLUMNS] = {&PLAIN, &BRIGHT, &DIM, &DIM};
    char cell[COLUMNS][CELL];
    fill_cells(parameter, cell);
    if (chosen) {
        overlay_box(pen->overlay, pen->left - 3.0f, pen->top - 2.0f, whole + 6.0f, LINE, BAND);
        overlay_text(pen->overlay, pen->left, pen->top, ">", BRIGHT);
    }
    float left = pen->left + GAP;
    for (int k = 0; k < COLUMNS; k++) {
        overlay_text(pen->overlay, left, pen->top, cell[k], chosen ? BRIGHT : *colours[k]);
        left += width[k] + (width[k] > 0.0f ? GAP : 0.0f);
    }
    pen->top += LINE;
}

static void status_text(const struct panel *panel, char *text, size_t size)
{
    snprintf(text, size, "view: %s", shader_view_name(panel->renderer->view));
    size_t used = strlen(text);
    if (panel->rate > 0.0)
        snprintf(text + used, size - used, "    %.0f fps, %.1f ms", panel->rate,
                 panel->milliseconds);
    used = strlen(text);
    if (panel->paused)
        snprintf(text + used, size - used, "    paused");
    used = strlen(text);
    if (panel->divisor > 1)
        snprintf(text + used, size - used, "    1/%d resolution while moving", panel->divisor);
}

// The first of the parameters to show where there is room for a number of them: the chosen one
// stays in sight.
static int first_shown(const struct panel *panel, int room)
{
    const struct parameters *parameters = &panel->renderer->parameters;
    const struct parameter *chosen =
        panel->chosen != NULL ? parameters_find(parameters, panel->chosen) : NULL;
    int index = chosen != NULL ? (int)(chosen - parameters->item) : 0;
    return index < room ? 0 : index - room + 1;
}

// The parameters that fit above bottom; where some do not, a line says which these are.
static void write_chapter(const struct panel *panel, struct overlay *overlay, float bottom)
{
    const struct parameters *parameters = &panel->renderer->parameters;
    char status[160], part[64];
    float width[COLUMNS] = {0};
    status_text(panel, status, sizeof status);
    float table = measure_columns(parameters, width);
    float whole = larger(larger(overlay_width(panel->title), overlay_width(status)), table);
    int room = (int)((bottom - MARGIN - 2.0f * PADDING + 2.0f) / LINE - 2.5f);
    bool cut = parameters->count > room;
    room = cut ? (room > 1 ? room - 1 : 0) : parameters->count;
    float lines = 2.0f + (float)room + (cut ? 1.0f : 0.0f) + (parameters->count > 0 ? 0.5f : 0.0f);
    struct pen pen = open_panel(overlay, MARGIN, MARGIN, whole, LINE * lines - 2.0f);
    write_line(&pen, panel->title, BRIGHT);
    write_line(&pen, status, PLAIN);
    if (parameters->count > 0)
        rule(&pen, whole);
    int first = first_shown(panel, room);
    for (int i = first; i < first + room; i++) {
        const struct parameter *parameter = &parameters->item[i];
        bool chosen = panel->chosen != NULL && strcmp(panel->chosen, parameter->name) == 0;
        write_parameter(&pen, parameter, chosen, width, whole);
    }
    snprintf(part, sizeof part, "%d to %d of %d", room > 0 ? first + 1 : 0, first + room,
             parameters->count);
    if (cut)
        write_line(&pen, part, DIM);
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
            float top = pen->top + LINE * (float)(lines - 1);
            overlay_text(pen->overlay, pen->left + at, top, key->label, BRIGHT);
            overlay_text(pen->overlay, pen->left + at + label + space, top, key->does, DIM);
        }
        *widest = larger(*widest, at + width);
        at += width + GAP;
    }
    return lines;
}

// The keys stand at the bottom. Returns the place of their panel's top.
static float write_keys(const struct panel *panel, struct overlay *overlay)
{
    float bottom = picture_height(overlay) - MARGIN, widest;
    if (panel->key_count == 0 || panel->folded)
        return bottom;
    float limit = picture_width(overlay) - 2.0f * (MARGIN + PADDING);
    float height = LINE * (float)lay_keys(panel, NULL, limit, &widest) - 2.0f;
    float top = bottom - height - 2.0f * PADDING;
    struct pen pen = open_panel(overlay, MARGIN, top, widest, height);
    lay_keys(panel, &pen, limit, &widest);
    return top - MARGIN;
}

// ---- Error ----

// Copy the part of a text that fits one line, and go on behind it. False at the end.
static bool next_line(const char **text, float limit, char line[OVERLAY_TEXT + 1])
{
    size_t length = 0, end = strcspn(*text, "\n");
    if (**text == '\0')
        return false;
    do {
        line[length] = (*text)[length];
        line[++length] = '\0';
    } while (length < end && length < OVERLAY_TEXT && overlay_width(line) < limit);
    if (end == 0)
        line[0] = '\0';
    else if (length < end || overlay_width(line) > limit)
        line[length > 1 ? --length : length] = '\0';
    *text += end == 0 ? 1 : length;
    if (end > 0 && **text == '\n')
        (*text)++;
    return true;
}

// Above the keys. A long one is cut where its panel would fill more than half of the picture.
static float write_error(const struct panel *panel, struct overlay *overlay, float bottom)
{
    const char *heading = panel->broken
                              ? "Error: the last good picture stays until the next good save"
                              : "This view can't be shown";
    char line[OVERLAY_TEXT + 1];
    float limit = picture_width(overlay) - 2.0f * (MARGIN + PADDING);
    int most = (int)(0.5f * picture_height(overlay) / LINE), lines = 0;
    if (panel->error == NULL || panel->error[0] == '\0')
        return bottom;
    for (const char *at = panel->error; lines < most && next_line(&at, limit, line);)
        lines++;
    float height = LINE * ((float)lines + 1.5f) - 2.0f;
    float top = bottom - height - 2.0f * PADDING;
    struct pen pen = open_panel(overlay, MARGIN, top, limit, height);
    overlay_box(overlay, MARGIN, top, 2.0f, height + 2.0f * PADDING, BRIGHT);
    write_line(&pen, heading, BRIGHT);
    rule(&pen, limit);
    for (const char *at = panel->error; lines > 0 && next_line(&at, limit, line); lines--)
        write_line(&pen, line, PLAIN);
    return top - MARGIN;
}

// ---- One ray ----

static void write_cross(const struct panel *panel, struct overlay *overlay)
{
    // Four arms that leave the pixel itself free; a dark edge shows them on a bright picture.
    static const float arms[4][4] = {{-8, 0, 5, 1}, {4, 0, 5, 1}, {0, -8, 1, 5}, {0, 4, 1, 5}};
    float x = ((float)panel->pixel[0] + 0.5f) / overlay->scale - 0.5f;
    float y = ((float)(overlay->height - 1 - panel->pixel[1]) + 0.5f) / overlay->scale - 0.5f;
    for (int i = 0; i < 4; i++) {
        const float *arm = arms[i];
        overlay_box(overlay, x + arm[0] - 1, y + arm[1] - 1, arm[2] + 2, arm[3] + 2, DARK);
        overlay_box(overlay, x + arm[0], y + arm[1], arm[2], arm[3], BRIGHT);
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
    pen->top += LINE;
}

static void write_steps(struct pen *pen, const struct renderer_probe *probe, int most)
{
    int rows = probe_rows(probe), first = rows > most ? rows - most : 0;
    write_step(pen, (const char *const[]){"step", "t", "distance"}, DIM);
    for (int i = first; i < rows; i++) {
        char step[16], t[32], distance[32];
        snprintf(step, sizeof step, "%d", i);
        snprintf(t, sizeof t, "%.5f", (double)probe->step[i].t);
        snprintf(distance, sizeof distance, "%.6f", (double)probe->step[i].distance);
        write_step(pen, (const char *const[]){step, t, distance}, i == rows - 1 ? BRIGHT : PLAIN);
    }
}

static void write_outcome(struct pen *pen, const struct renderer_probe *probe)
{
    char text[80];
    write_line(pen, probe_end(probe), BRIGHT);
    snprintf(text, sizeof text, "steps %d, of all marches %d", probe->steps, probe->all_steps);
    write_line(pen, text, PLAIN);
    snprintf(text, sizeof text, "evaluations of the scene %d", probe->evaluations);
    write_line(pen, text, PLAIN);
}

static void write_march(const struct panel *panel, struct overlay *overlay, float bottom)
{
    const struct renderer_probe *probe = panel->probe;
    float left = picture_width(overlay) - MARGIN - INSPECTOR_WIDTH - 2.0f * PADDING;
    // Heading, titles, three lines of the outcome, two rules.
    int most = (int)((bottom - MARGIN - 2.0f * PADDING) / LINE) - 6;
    int rows = probe_rows(probe) < most ? probe_rows(probe) : most;
    rows = rows < 0 ? 0 : rows;
    char heading[80];
    snprintf(heading, sizeof heading, "%s %d, %d",
             rows < probe_rows(probe) ? "last steps of pixel" : "ray of pixel", panel->pixel[0],
             panel->pixel[1]);
    struct pen pen =
        open_panel(overlay, left, MARGIN, INSPECTOR_WIDTH, LINE * ((float)rows + 6.0f) - 2.0f);
    write_line(&pen, heading, BRIGHT);
    rule(&pen, INSPECTOR_WIDTH);
    write_steps(&pen, probe, rows);
    rule(&pen, INSPECTOR_WIDTH);
    write_outcome(&pen, probe);
}

// Why there is no march to show, in as many lines as it needs.
static void write_why(const struct panel *panel, struct overlay *overlay)
{
    char line[OVERLAY_TEXT + 1];
    int lines = 0;
    for (const char *at = panel->why; next_line(&at, WHY_WIDTH, line);)
        lines++;
    float left = picture_width(overlay) - MARGIN - WHY_WIDTH - 2.0f * PADDING;
    struct pen pen = open_panel(overlay, left, MARGIN, WHY_WIDTH, LINE * (float)lines - 2.0f);
    for (const char *at = panel->why; next_line(&at, WHY_WIDTH, line);)
        write_line(&pen, line, PLAIN);
}

void panel_gather(const struct panel *panel, struct overlay *overlay, int width, int height,
                  float scale)
{
    overlay_begin(overlay, width, height, scale);
    float bottom = write_keys(panel, overlay);
    bottom = write_error(panel, overlay, bottom);
    if (!panel->folded)
        write_chapter(panel, overlay, bottom);
    if (panel->pixel[0] >= 0 && panel->probe != NULL)
        write_march(panel, overlay, bottom);
    else if (panel->pixel[0] >= 0 && panel->why != NULL)
        write_why(panel, overlay);
    // The slice is another picture, in which the pixel is nowhere.
    if (panel->pixel[0] >= 0 && panel->renderer->view != SHADER_SLICE)
        write_cross(panel, overlay);
}
