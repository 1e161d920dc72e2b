// panel.c - tests the words of the panels and their positions. The tests draw no picture, but
// examine the letters of the overlay.
#include "lib/test.h"
#include "picture/panel.h"
#include "picture/pen.h"

static struct overlay overlay;
static struct parameter parameters[] = {
    {.name = "long", .components = 1, .maximum = 8.0, .unit = "metres"},
    {.name = "wide", .components = 1, .maximum = 9.0, .unit = "feet"},
    {.name = "high", .components = 1, .maximum = 7.0, .unit = "yards"},
};
static struct renderer renderer = {.parameters = {.item = parameters, .count = 3}};
static const struct probe probe = {
    .step = {{.t = 0.0f, .distance = 1.5f}, {.t = 1.5f, .distance = 0.25f}},
    .steps = 2,
    .all_steps = 71,
    .evaluations = 346,
    .end = PROBE_PASSED,
    .recorded = true,
    .colour = {7, 0, 255}};

static int close_overlay(void **unused)
{
    (void)unused;
    overlay_close(&overlay);
    return 0;
}

// True if the rectangles from expected on are the letters of a text, all moved by the same
// distance.
static bool stands_at(const struct overlay_rectangle *text, int count,
                      const struct overlay_rectangle *expected)
{
    float right = expected->left - text->left, down = expected->top - text->top;
    for (int i = 0; i < count; i++)
        if (expected[i].letter != text[i].letter ||
            fabsf(expected[i].left - text[i].left - right) > 0.01f ||
            fabsf(expected[i].right - text[i].right - right) > 0.01f ||
            fabsf(expected[i].top - text[i].top - down) > 0.01f ||
            fabsf(expected[i].bottom - text[i].bottom - down) > 0.01f)
            return false;
    return true;
}

static bool says(const char *text)
{
    struct overlay words = {0};
    bool found = false;
    overlay_text(&words, 0.0f, 0.0f, text, (struct overlay_colour){{0}});
    assert_true(words.count > 0);
    for (int i = 0; i + words.count <= overlay.count && !found; i++)
        found = stands_at(words.rectangle, words.count, &overlay.rectangle[i]);
    overlay_close(&words);
    return found;
}

TEST(a_ray_s_march_is_described)
{
    struct panel panel = {.renderer = &renderer, .title = "", .pixel = {31, 47}, .probe = &probe};
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("ray of pixel 31, 47"));
    assert_true(says("1.50000") && says("0.250000"));
    assert_true(says("miss: passed the far limit"));
    assert_true(says("steps 2 (further rays: 69)"));
    assert_true(says("evaluations of the scene 346"));
    assert_true(says("colour 7, 0, 255"));
}

TEST(the_status_is_described)
{
    struct panel panel = {.renderer = &renderer, .title = "A title", .pixel = {-1, -1}};
    panel.rate = 59.8;
    panel.milliseconds = 16.7;
    panel.paused = true;
    panel.hint = "H: help";
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("A title") && says("view: picture    paused"));
    panel.timed = true;
    panel.time = 20.04;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("view: picture    paused    time 20.0 s"));
    panel.averaged = 7;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("view: picture    paused    mean of 7 frames"));
    panel.averaged = 0;
    panel.paused = false;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("view: picture    60 fps    time 20.0 s") && says("H: help"));
    panel.resolution = 35;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("H: help    35 % resolution")); // the hint stays visible while something moves
    panel.sharp = 40;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("H: help    sharpening: 40 %"));
    panel.sharp = 100;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("H: help") && !says("resolution"));
    panel.rate = 0.0; // the picture is at rest, so there is no rate
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("view: picture    drawn in 16.7 ms    time 20.0 s"));
}

TEST(the_complete_table_names_the_textures)
{
    struct texture textures[] = {{.name = "granite"}, {.name = "noise"}};
    struct panel panel = {
        .renderer = &renderer, .title = "", .selected = &parameters[1], .pixel = {-1, -1}};
    renderer.textures = (struct textures){textures, 2};
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(!says("textures: granite, noise"));
    panel.ranges = true;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("[0, 8]") && says("textures: granite, noise"));
    renderer.textures = (struct textures){NULL, 0};
}

// The range of a parameter that is not selected appears only in the complete table.
TEST(the_table_is_complete_if_there_is_room)
{
    struct panel panel = {
        .renderer = &renderer, .title = "", .selected = &parameters[1], .pixel = {-1, -1}};
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("[0, 9] feet") && !says("[0, 8]"));
    panel.ranges = true;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("[0, 8]") && says("metres") && says("[0, 7]"));
    float width = overlay.rectangle[0].right + 8.0f; // including the panel's right margin
    panel_gather(&panel, &overlay, (int)width, 360, 1.0f);
    assert_true(says("[0, 8]"));
    panel_gather(&panel, &overlay, (int)width - 1, 360, 1.0f);
    assert_true(says("[0, 9] feet") && !says("[0, 8]"));
    panel.selected = NULL;
    panel_gather(&panel, &overlay, (int)width - 1, 360, 1.0f);
    assert_true(says("[0, 8]"));
}

// If there are more parameters than fit, the selected parameter is visible, with its details.
TEST(a_panel_scrolls_to_the_selected_parameter)
{
    enum { MANY = 20, HEIGHT = 240 };
    struct parameter item[MANY] = {0};
    struct renderer many = {.parameters = {.item = item, .count = MANY}};
    struct panel panel = {.title = "A title", .renderer = &many, .pixel = {-1, -1}};
    for (int i = 0; i < MANY; i++) {
        snprintf(item[i].name, sizeof item[i].name, "parameter%d", i);
        snprintf(item[i].unit, sizeof item[i].unit, "unit%d", i);
        item[i].components = 1;
    }
    for (int i = 0; i < MANY; i++) {
        panel.selected = &item[i];
        panel_gather(&panel, &overlay, 400, HEIGHT, 1.0f);
        char detail[64];
        snprintf(detail, sizeof detail, "[0, 0] unit%d", i);
        assert_true(says(panel.selected->name) && says(detail) && says("of 20"));
        assert_true(overlay.rectangle[0].bottom < HEIGHT);
    }
    panel_gather(&panel, &overlay, 400, 70, 1.0f); // no room for a single parameter
    assert_true(says("20 parameters") && !says("0 to 0"));
}

// The panels of the chapter and of the ray are side by side. If there is room for only one panel,
// the ray's panel is shown.
TEST(the_panel_of_a_ray_takes_precedence)
{
    struct panel panel = {
        .renderer = &renderer, .title = "A title", .pixel = {1, 2}, .probe = &probe};
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(says("A title") && says("ray of pixel 1, 2"));
    panel_gather(&panel, &overlay, 260, 360, 1.0f);
    assert_true(!says("A title") && says("ray of pixel 1, 2"));
    panel.pixel[0] = -1;
    panel_gather(&panel, &overlay, 260, 360, 1.0f);
    assert_true(says("A title"));
}

// The width of a panel's contents is rounded up to a multiple of 20 units, so that the panel keeps
// its width while the digits of the frame rate change.
TEST(a_panel_keeps_its_width)
{
    struct panel panel = {.renderer = &renderer, .title = "", .rate = 11.0, .pixel = {-1, -1}};
    renderer.parameters.count = 0;
    for (double width = 0.0; panel.rate < 100.0; panel.rate += 11.0) {
        panel_gather(&panel, &overlay, 640, 360, 1.0f);
        double now = (double)(overlay.rectangle[0].right - overlay.rectangle[0].left) - 14.0;
        assert_true(fmod(now, 20.0) == 0.0 && (width == 0.0 || now == width));
        width = now;
    }
    renderer.parameters.count = 3;
}

// In a picture of any size, a panel with a long error takes at most half the picture's height plus
// three lines. In a picture of at least 320x180 units, nothing is outside the picture.
TEST(a_panel_fits_any_picture)
{
    char error[6000];
    memset(error, 'x', sizeof error - 1);
    error[sizeof error - 1] = '\0';
    for (size_t i = 50; i < sizeof error - 1; i += 377)
        error[i] = '\n';
    struct panel panel = {.title = "A title",
                          .renderer = &renderer,
                          .pixel = {100, 100},
                          .why = "a reason\n\nof three lines",
                          .error = error};
    static const int sizes[][2] = {{1, 1},     {30, 20},   {320, 200}, {640, 9},
                                   {16384, 1}, {1, 16384}, {1280, 720}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int power = -1; power <= 3; power++) {
            float scale = ldexpf(1.0f, power), width = (float)sizes[i][0] / scale;
            float height = (float)sizes[i][1] / scale;
            panel_gather(&panel, &overlay, sizes[i][0], sizes[i][1], scale);
            const struct overlay_rectangle *back = &overlay.rectangle[0];
            assert_true(back->bottom - back->top <= 0.5f * height + 3.0f * OVERLAY_LINE);
            for (int k = 0; k < overlay.count && width >= 320.0f && height >= 180.0f; k++)
                assert_true(overlay.rectangle[k].left >= 0.0f && overlay.rectangle[k].top >= 0.0f &&
                            overlay.rectangle[k].right <= width &&
                            overlay.rectangle[k].bottom <= height);
        }
}

// A line contains as much text as fits, ends between words if there is a space, and keeps the
// indentation, which marks a line of code in an error.
TEST(a_line_ends_between_words)
{
    static const char *const lines[] = {"here: a long", "reason", "    int x;", "aaaaaaaaaaaa",
                                        "aaa bb"};
    const char *at = "here: a long reason\n    int x;\naaaaaaaaaaaaaaa bb";
    float limit = 0.0f;
    for (int i = 0; i < 12; i++)
        limit += letters_advance('a');
    char line[OVERLAY_TEXT + 1];
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        assert_true(pen_next_line(&at, limit, line));
        assert_string_equal(line, lines[i]);
    }
    assert_false(pen_next_line(&at, limit, line));
}

// Check the words and the position of each row, from the top, and that panel_rows_at finds the row
// at this position.
TEST(rows_are_below_each_other)
{
    static const char *const texts[] = {"A title",     "view: picture", "", "long",   "wide",
                                        "[0, 9] feet", "high",          "", "H: help"};
    static const float tops[] = {16, 28, 40, 46, 58, 70, 82, 94, 100};
    struct panel_rows rows = {0};
    struct panel panel = {.renderer = &renderer,
                          .title = "A title",
                          .selected = &parameters[1],
                          .hint = "H: help",
                          .pixel = {-1, -1},
                          .rows = &rows};
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_int_equal(rows.count, 9);
    for (int i = 0; i < rows.count; i++) {
        const struct panel_row *row = &rows.row[i];
        assert_string_equal(row->cell[0], texts[i]);
        assert_true(row->top == tops[i] && row->left == 15.0f);
        assert_ptr_equal(panel_rows_at(&rows, row->left, row->top), row);
    }
    assert_null(panel_rows_at(&rows, rows.left + rows.width, 50.0f));
    panel.right = true;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(rows.left + rows.width == 632.0f && rows.row[3].left == rows.left + 7.0f);
    panel.rolled = true;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_int_equal(rows.count, 1);
    panel.folded = true;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_int_equal(rows.count, 0);
    panel_rows_free(&rows);
}

// A value that is set from a position in the parameter's range has that position. On a logarithmic
// scale, the middle of [0.01, 1] is 0.1.
TEST(a_position_gives_a_value)
{
    struct parameter linear = {.components = 1, .minimum = -2.0, .maximum = 6.0};
    struct parameter decades = {
        .components = 1, .minimum = 0.01, .maximum = 1.0, .step = 2.0, .multiplies = true};
    parameter_put(&linear, 0, 0.25);
    assert_true(linear.value[0] == 0.0 && parameter_fraction(&linear, 0) == 0.25);
    parameter_put(&linear, 0, 7.0);
    assert_true(linear.value[0] == 6.0);
    parameter_put(&decades, 0, 0.5);
    assert_true(decades.value[0] == 0.1 && fabs(parameter_fraction(&decades, 0) - 0.5) < 1e-12);
    parameter_put(&decades, 0, -1.0);
    assert_true(decades.value[0] == 0.01);
}

TESTS(NULL, close_overlay)
