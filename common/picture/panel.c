#include "picture/panel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/probe.h"

// Units of the overlay.
#define MARGIN  8.0f // of a panel from the picture's edge
#define PADDING 7.0f // of the text from the panel's edge
#define GAP     12.0f
#define LINE    OVERLAY_LINE

static const struct overlay_colour BACKGROUND = {{10, 12, 16, 192}};
static const struct overlay_colour BAND = {{255, 255, 255, 38}};
static const struct overlay_colour RULE = {{255, 255, 255, 46}};
static const struct overlay_colour BRIGHT = {{250, 250, 250, 255}};
static const struct overlay_colour PLAIN = {{226, 229, 234, 255}};
static const struct overlay_colour DIM = {{190, 196, 206, 255}};
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
    static const struct overlay_colour *const colours[COLUMNS] = {&PLAIN, &BRIGHT, &DIM, &DIM};
    char cell[COLUMNS][CELL];
    fill_cells(parameter, cell);
    bool detailed = chosen && !form->ranges;
    if (chosen) {
        overlay_box(pen->overlay, pen->left - 3.0f, pen->top - 2.0f, form->width + 6.0f,
                    detailed ? 2.0f * LINE : LINE, BAND);
        overlay_text(pen->overlay, pen->left, pen->top, ">", BRIGHT);
    }
    float left = pen->left + GAP;
    for (int k = 0; k < (form->ranges ? COLUMNS : 2); k++) {
        overlay_text(pen->overlay, left, pen->top, cell[k], chosen ? BRIGHT : *colours[k]);
        left += form->column[k] + (form->column[k] > 0.0f ? GAP : 0.0f);
    }
    pen->top += LINE;
    if (detailed) {
        overlay_text(pen->overlay, pen->left + 2.0f * GAP, pen->top, form->detail, PLAIN);
        pen->top += LINE;
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
    if (panel->divisor > 1 && panel->sharp == 0)
        snprintf(text, size, "1/%d resolution while moving", panel->divisor);
    else if (panel->divisor > 1 && panel->sharp < 100)
        snprintf(text, size, "1/%d resolution; sharpening: %d %%", panel->divisor, panel->sharp);
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
    form->width = larger(texts, table);
    form->lines = 2.0f + (parameters->count > 0 ? 0.5f : 0.0f) + (form->ranges ? 0.0f : 1.0f) +
                  (form->last[0] != '\0' ? 1.5f : 0.0f) + (form->textures[0] != '\0' ? 1.0f : 0.0f);
    int room = (int)((bottom - MARGIN - 2.0f * PADDING + 2.0f) / LINE - form->lines);
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
    struct pen pen = open_panel(overlay, MARGIN, MARGIN, form->width, LINE * form->lines - 2.0f);
    write_line(&pen, panel->title, BRIGHT);
    write_line(&pen, form->status, PLAIN);
    if (parameters->count > 0)
        rule(&pen, form->width);
    for (int i = form->first; i < form->first + form->rows; i++)
        write_parameter(&pen, &parameters->item[i], &parameters->item[i] == panel->chosen, form);
    char part[64];
    snprintf(part, sizeof part, "%d to %d of %d", form->rows > 0 ? form->first + 1 : 0,
             form->first + form->rows, parameters->count);
    if (form->cut)
        write_line(&pen, part, DIM);
    if (form->textures[0] != '\0')
        write_line(&pen, form->textures, DIM);
    if (form->last[0] != '\0') {
        rule(&pen, form->width);
        write_line(&pen, form->last, DIM);
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

static void write_steps(struct pen *pen, const struct probe *probe, int most)
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

static void write_outcome(struct pen *pen, const struct probe *probe)
{
    char text[80];
    write_line(pen, probe_outcome(probe), BRIGHT);
    int others = probe->all_steps - probe->steps;
    snprintf(text, sizeof text, others > 0 ? "steps %d, of further rays %d" : "steps %d",
             probe->steps, others);
    write_line(pen, text, PLAIN);
    snprintf(text, sizeof text, "evaluations of the scene %d", probe->evaluations);
    write_line(pen, text, PLAIN);
    snprintf(text, sizeof text, "colour %d, %d, %d", probe->colour[0], probe->colour[1],
             probe->colour[2]);
    write_line(pen, text, PLAIN);
}

static float march_left(const struct overlay *overlay)
{
    return picture_width(overlay) - MARGIN - INSPECTOR_WIDTH - 2.0f * PADDING;
}

static void write_march(const struct panel *panel, struct overlay *overlay, float bottom)
{
    const struct probe *probe = panel->probe;
    // Heading, titles, four lines of the outcome, two rules.
    int most = (int)((bottom - MARGIN - 2.0f * PADDING) / LINE) - 7;
    int rows = probe_rows(probe) < most ? probe_rows(probe) : most;
    if (rows < 1 && probe_rows(probe) > 0)
        return; // the keys take all the room
    rows = rows < 0 ? 0 : rows;
    char heading[80];
    snprintf(heading, sizeof heading, "%s %d, %d",
             rows < probe_rows(probe) ? "last steps of pixel" : "ray of pixel", panel->pixel[0],
             panel->pixel[1]);
    struct pen pen = open_panel(overlay, march_left(overlay), MARGIN, INSPECTOR_WIDTH,
                                LINE * ((float)rows + 7.0f) - 2.0f);
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
    bool marched = panel->pixel[0] >= 0 && panel->probe != NULL;
    bool refused = panel->pixel[0] >= 0 && !marched && panel->why != NULL;
    float bottom = write_error(panel, overlay, write_keys(panel, overlay));
    float right = picture_width(overlay) - MARGIN;
    if (marched)
        right = march_left(overlay) - MARGIN;
    else if (refused)
        right -= WHY_WIDTH + 2.0f * PADDING + MARGIN;
    struct chapter_panel form;
    float room = right - MARGIN - 2.0f * PADDING;
    lay_chapter(panel, room, bottom, &form);
    // Where there is no room for both, the ray that was asked for is what is shown.
    if (!panel->folded && (form.width <= room || !(marched || refused)))
        write_chapter(panel, overlay, &form);
    bool slice = panel->renderer->view == SHADER_SLICE;
    if (marched && !(slice && panel->folded))
        write_march(panel, overlay, bottom);
    else if (refused)
        write_why(panel, overlay);
    // The slice is another picture, in which the pixel is nowhere.
    if (panel->pixel[0] >= 0 && !slice)
        write_cross(panel, overlay);
}
