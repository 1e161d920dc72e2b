// boxes.c - tests the layout of the panels over every chapter's picture, in every view, with short
// and long key names, at common sizes and scales. No panel covers another or is cut off, each
// letter is inside its panel and does not overlap the letter before it, and the text of a slice or
// a plot stays visible. The help for a row and the colour picker are notes, which are drawn over
// the panels: each is complete and does not cover the rows that it belongs to. The test compares
// positions; it draws no picture.
#include <glob.h>

#include "lib/test.h"

#include "picture/comparison.h"
#include "picture/pen.h"
#include "picture/slice.h"
#include "shader/source.h"
#include "window/keys.h"
#include "window/state.h"
#include "lib/gpu.h"

enum { BACKS = 16 };

// True if each key's name on the keyboard is four letters long, the longest that the key list
// accepts; otherwise it is one letter.
static bool long_names;

const char *glfwGetKeyName(int key, int scancode)
{
    static char name[8];
    (void)scancode;
    snprintf(name, sizeof name, "%s%c", long_names ? "WWW" : "", key);
    return name;
}

// Every shader appears to have the uniform that Tab changes, so the key list includes Tab.
static GLint has_uniform(GLuint program, const GLchar *name)
{
    (void)program, (void)name;
    return 0;
}
static const struct gl gl = {.GetUniformLocation = has_uniform};

// ---- Checks of the layout ----

static struct overlay overlay;
static const struct window_start start;
static struct window window = {.start = &start}; // provides the key list

// A panel, found by its background.
struct back {
    struct overlay_rectangle box;
    int first; // index of the first rectangle in the panel, after the background
    bool note; // the panel is a note: a dark box of the same size is drawn under its background
};
static struct back backs[BACKS];
static int back_count;

static bool inside(const struct overlay_rectangle *a, const struct overlay_rectangle *in)
{
    return a->left >= in->left && a->top >= in->top && a->right <= in->right &&
           a->bottom <= in->bottom;
}

static bool meet(const struct overlay_rectangle *a, const struct overlay_rectangle *b)
{
    return a->left < b->right && b->left < a->right && a->top < b->bottom && b->top < a->bottom;
}

static bool is_box(const struct overlay_rectangle *box, int grey, int opacity)
{
    return box->letter == 0 && box->width == 0.0f && box->colour.channel[0] == grey &&
           box->colour.channel[3] == opacity;
}

// Find the panels: each begins with a box in the background colour.
static void find_backs(void)
{
    back_count = 0;
    for (int i = 0; i < overlay.count && back_count < BACKS; i++) {
        const struct overlay_rectangle *box = &overlay.rectangle[i];
        if (is_box(box, 10, 192))
            backs[back_count++] = (struct back){*box, i + 1,
                                                i > 0 && is_box(&box[-1], 0, PEN_DARK.channel[3]) &&
                                                    inside(&box[-1], box) && inside(box, &box[-1])};
    }
}

// True if two consecutive letters do not overlap: they are side by side on one line, or their lines
// are at least 10 units apart.
static bool parted(const struct overlay_rectangle *a, const struct overlay_rectangle *b)
{
    float down = fabsf(a->top - b->top);
    return down < 0.01f ? b->left >= a->right - 0.01f || b->right <= a->left + 0.01f
                        : down >= 10.0f;
}

// Check that each letter is inside the most recent panel and does not overlap the letter before it.
//   typed  a text field covers a row, so letters may overlap
static void judge_letters(const char *where, bool typed)
{
    const struct overlay_rectangle *before = NULL;
    int in = -1;
    for (int i = 0; i < overlay.count; i++) {
        const struct overlay_rectangle *letter = &overlay.rectangle[i];
        while (in + 1 < back_count && backs[in + 1].first <= i) {
            in++;
            before = NULL;
        }
        if (letter->letter == 0)
            continue;
        if (in < 0 || !inside(letter, &backs[in].box))
            fail_msg("%s: the letter %c is in no panel", where, (char)letter->letter);
        if (before != NULL && !typed && !parted(before, letter))
            fail_msg("%s: the letters %c and %c overlap", where, (char)before->letter,
                     (char)letter->letter);
        before = letter;
    }
}

static void judge(const char *where, bool typed)
{
    const struct overlay_rectangle picture = {.right = pen_picture_width(&overlay),
                                              .bottom = pen_picture_height(&overlay)};
    find_backs();
    for (int i = 0; i < back_count; i++) {
        if (!inside(&backs[i].box, &picture))
            fail_msg("%s: panel %d is cut off", where, i);
        for (int k = 0; k < i; k++)
            if (backs[k].note == backs[i].note && meet(&backs[i].box, &backs[k].box))
                fail_msg("%s: panels %d and %d overlap", where, k, i);
    }
    judge_letters(where, typed);
}

// Check that no panel covers the text of a slice or a plot: the axis along the ray, the ray with
// its numbers, and the graph. Notes may cover all three, and the keys may cover the last two.
//   passing  the number of key panels, which come first: 0 or 1
static void judge_slice(const char *where, enum shader_view view, int passing)
{
    if (!shader_shows_ray(view))
        return;
    float width = pen_picture_width(&overlay), height = pen_picture_height(&overlay);
    float cell = slice_cell(overlay.height) / overlay.scale;
    float graph = view == VIEW_PLOT ? SLICE_PLOT * height : 0.0f;
    float ray = 0.5f * (height - graph);
    const struct overlay_rectangle written[] = {
        {.top = height - SLICE_AXIS * cell, .right = width, .bottom = height},
        {.top = ray - SLICE_NUMBER * cell, .right = width, .bottom = ray + 0.02f * height},
        {.top = height - graph, .right = width, .bottom = height}};
    for (int i = 0; i < back_count; i++)
        for (int k = 0; k < 3; k++)
            if (!backs[i].note && (k == 0 || i >= passing) && meet(&backs[i].box, &written[k]))
                fail_msg("%s: panel %d covers the %s", where, i,
                         (const char *[]){"axis", "ray", "graph"}[k]);
}

// Check that no panel covers the legend, which is 84 cells wide and 18 high (shaders/views.glsl).
static void judge_legend(const char *where, enum shader_view view)
{
    float cell = slice_cell(overlay.height) / overlay.scale, height = pen_picture_height(&overlay);
    const struct overlay_rectangle legend = {
        .top = height - 18.0f * cell, .right = 84.0f * cell, .bottom = height};
    for (int i = 0; i < back_count && shader_has_legend(view); i++)
        if (!backs[i].note && meet(&backs[i].box, &legend))
            fail_msg("%s: panel %d covers the legend", where, i);
}

// Check that the last panel is a note, that it does not cover the rows that it belongs to, and that
// its background contains everything drawn in it.
//   first, behind  the rows from first to behind - 1
static void judge_note(const char *where, const struct panel_rows *rows, int first, int behind)
{
    const struct back *note = back_count > 0 ? &backs[back_count - 1] : NULL;
    if (note == NULL || !note->note) {
        fail_msg("%s: there is no note", where);
        return;
    }
    for (int i = first; i < behind; i++) {
        const struct panel_row *row = &rows->row[i];
        const struct overlay_rectangle box = {.left = row->left,
                                              .top = row->top - 1.0f,
                                              .right = row->left + row->width,
                                              .bottom = row->top + row->height - 3.0f};
        if (meet(&note->box, &box))
            fail_msg("%s: the note covers row %d, to which it belongs", where, i);
    }
    for (int i = note->first; i < overlay.count; i++)
        if (!inside(&overlay.rectangle[i], &note->box))
            fail_msg("%s: the note extends beyond its background", where);
}

// ---- A picture of a chapter ----

static const char *const refusal = "type digits, a point, a sign or an e; hold Shift for "
                                   "digits on a French keyboard";

struct way {
    const int *size;
    float scale;
    char where[256];
};

static void gather(struct panel *panel, const struct way *way)
{
    panel_gather(panel, &overlay, way->size[0], way->size[1], way->scale);
}

// Try the help for one row: the meaning of its parameter, or the reason why a field rejects the
// typed text.
static void try_help(struct panel panel, const struct way *way, int turn)
{
    struct panel_rows *rows = panel.rows;
    int first = turn % (rows->count > 0 ? rows->count : 1);
    if (rows->count == 0 || rows->row[first].parameter < 0)
        return;
    const struct parameter *parameter =
        comparison_parameter(panel.renderer, rows->row[first].parameter);
    panel.refused = turn % 3 == 0;
    panel.tip = panel.refused ? refusal : parameter->meaning;
    panel.tip_at[0] = rows->row[first].left + 0.5f * rows->row[first].width;
    panel.tip_at[1] = rows->row[first].top + 1.0f;
    gather(&panel, way);
    judge(way->where, false);
    judge_note(way->where, rows, first, first + 1);
    size_t letters = 0, written = 0;
    for (const char *at = panel.tip; *at != '\0';)
        letters += letters_next(&at) != ' ';
    for (int i = backs[back_count - 1].first; i < overlay.count; i++)
        written += overlay.rectangle[i].letter != 0 && overlay.rectangle[i].letter != ' ';
    if (written != letters)
        fail_msg("%s: the help has %zu letters, but %zu are drawn", way->where, letters, written);
}

// Try the colour picker, and a text field full of digits.
static void try_colour(struct panel panel, const struct way *way, int turn)
{
    int count = comparison_parameter_count(panel.renderer), first = -1, behind = 0;
    struct picker picker = {.hsv = {0.3, 1.0, 0.0}};
    struct panel_rows *rows = panel.rows;
    for (int i = 0; i < count; i++)
        if (parameter_is_colour(comparison_parameter(panel.renderer, (i + turn) % count)))
            panel.selected = comparison_parameter(panel.renderer, (i + turn) % count);
    panel.typed = "-0.1234567,-0.1234567,-0.1234567,-0.1234";
    panel.typed_part = turn % 4 - 1;
    gather(&panel, way);
    judge(way->where, true);
    panel.typed = NULL;
    panel.picker = &picker;
    gather(&panel, way);
    judge(way->where, false);
    for (int i = 0; i < rows->count; i++) {
        first = first < 0 && rows->row[i].selected ? i : first;
        behind = rows->row[i].selected ? i + 1 : behind;
    }
    if (picker.width > 0.0f)
        judge_note(way->where, rows, first, behind);
    else if (first >= 0 && rows->row[first].swatch > 0.0f)
        fail_msg("%s: the colour has no picker", way->where);
}

// Try a picture with short key names, with long ones and without keys, with and without a ray, and
// with the panel on either side. Every third case also tries a colour, so colours are tried at each
// size, with and without keys.
static void try_picture(struct renderer *chapter, const char *name, const int size[2], float scale)
{
    static struct probe probe = {.steps = 40, .all_steps = 60, .recorded = true};
    struct panel_rows rows = {0};
    struct way way = {.size = size, .scale = scale};
    const struct parameters *all = &chapter->parameters;
    for (int turn = 0; turn < 12; turn++) {
        bool ray = turn % 2 == 1, right = turn / 2 % 2 == 1, helps = turn >= 4;
        long_names = turn >= 8;
        window.renderer = chapter;
        window.has_keyboard = true;
        window.panel.helps = helps;
        window.inputs.pixel[0] = ray ? size[0] / 2 : -1;
        window_list_keys(&window);
        struct panel panel = {.title = "21 A chapter with a name",
                              .renderer = chapter,
                              .selected = all->count > 0 ? &all->item[all->count - 1] : NULL,
                              .rate = 123.0,
                              .milliseconds = 123.4,
                              .timed = true,
                              .time = 1234.5,
                              .paused = true,
                              .ranges = helps,
                              .right = right,
                              .hint = window.panel.hint,
                              .keys = window.panel.keys,
                              .key_count = helps ? window.panel.key_count : 0,
                              .pixel = {window.inputs.pixel[0], size[1] / 2},
                              .probe = &probe,
                              .rows = &rows};
        gather(&panel, &way);
        snprintf(way.where, sizeof way.where, "%s, %s, %dx%d at %g%s%s%s", name,
                 shader_view_name(chapter->view), size[0], size[1], (double)scale,
                 helps ? ", keys" : "", ray ? ", with a ray" : "", right ? ", on the right" : "");
        judge(way.where, false);
        judge_slice(way.where, chapter->view, helps);
        judge_legend(way.where, chapter->view);
        try_help(panel, &way, turn + (int)chapter->view);
        if (all->count > 0 && turn % 3 == 0)
            try_colour(panel, &way, turn);
    }
    panel_rows_free(&rows);
}

static const int sizes[][2] = {{320, 180},  {480, 270},   {640, 360},   {960, 540},
                               {1280, 720}, {1920, 1080}, {3840, 2160}, {640, 1000}};
static const float scales[] = {1.0f, 1.5f, 2.0f, 3.0f};

static bool is_usual(const int *size, float scale)
{
    return (float)size[0] / scale >= 320.0f && (float)size[1] / scale >= 180.0f;
}

TEST(no_panel_covers_another)
{
    char pattern[4200];
    glob_t found;
    snprintf(pattern, sizeof pattern, "%s/chapters/[0-9][0-9]_*.frag", gpu_project_root());
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    assert_true(found.gl_pathc > 20);
    for (size_t c = 0; c < found.gl_pathc; c++) {
        struct shader_source source = {0};
        struct renderer chapter = {.gl = &gl};
        const char *path = found.gl_pathv[c];
        assert_true(shader_read(&source, path, gpu_project_root()) &&
                    parameters_read(&chapter.parameters, &source));
        for (int i = 0; i < 8 * 4 * SHADER_VIEW_COUNT; i++) {
            chapter.view = (enum shader_view)(i / 32);
            if (is_usual(sizes[i % 8], scales[i / 8 % 4]))
                try_picture(&chapter, strrchr(path, '/') + 1, sizes[i % 8], scales[i / 8 % 4]);
        }
        parameters_free(&chapter.parameters);
        shader_free(&source);
    }
    globfree(&found);
}

static int close_overlay(void **unused)
{
    (void)unused;
    overlay_close(&overlay);
    return 0;
}

TESTS(NULL, close_overlay)
