// inspector.c - tests the table of the selected ray and the marks on the ray: which rows are
// visible, that the table covers neither the selected pixel nor the ray, and where the dot and the
// arrow are. The tests draw no picture, but examine the rectangles of the overlay.
#include "lib/test.h"
#include "picture/panel.h"
#include "picture/pen.h"

enum { STEPS = 60 };
#define TABLE_WIDTH 190.0f // units of the overlay

static struct overlay overlay;
static struct parameter parameters[] = {{.name = "long", .components = 1, .unit = "metres"},
                                        {.name = "wide", .components = 1, .unit = "feet"}};
static struct renderer renderer = {.parameters = {.item = parameters, .count = 2}};
static struct probe probe;

static const int sizes[][2] = {{320, 180}, {640, 360}, {960, 540}, {1920, 1080}, {3840, 2160}};

static int set_up(void **unused)
{
    (void)unused;
    memset(&probe, 0, sizeof probe);
    probe.steps = probe.all_steps = STEPS;
    probe.recorded = true;
    probe.end = PROBE_PASSED;
    for (int k = 0; k < STEPS; k++)
        probe.step[k] =
            (struct probe_step){.t = 0.125f * (float)k, .distance = 0.5f + (float)k, .seen = true};
    renderer.view = VIEW_PICTURE;
    return 0;
}

static int tear_down(void **unused)
{
    (void)unused;
    overlay_close(&overlay);
    return 0;
}

static void gather(int width, int height, int x, int y, float shown)
{
    for (int k = 0; k < STEPS && !probe.pinned; k++) {
        probe.step[k].pixel[0] = (float)x + 0.5f;
        probe.step[k].pixel[1] = (float)y + 0.5f;
    }
    struct panel panel = {.renderer = &renderer,
                          .title = "A title",
                          .ranges = true,
                          .pixel = {x, y},
                          .shown = shown,
                          .probe = &probe};
    panel_gather(&panel, &overlay, width, height, overlay_scale_of(height));
}

static bool coloured(const struct overlay_rectangle *box, struct overlay_colour colour)
{
    return memcmp(&box->colour, &colour, sizeof colour) == 0;
}

// Find the background of the ray's table. Returns NULL if there is no table.
static const struct overlay_rectangle *table(void)
{
    const struct overlay_rectangle *found = NULL;
    for (int i = 0; i < overlay.count; i++) {
        const struct overlay_rectangle *box = &overlay.rectangle[i];
        if (box->letter == 0 && box->width == 0.0f && box->colour.channel[3] == 192 &&
            fabsf(box->right - box->left - TABLE_WIDTH) < 0.1f)
            found = box;
    }
    return found;
}

// Find the upper edge of a line of text, in units of the overlay. Returns -1 if the text is not
// drawn.
static float height_of(const char *text)
{
    struct overlay words = {0};
    float top = -1.0f;
    overlay_text(&words, 0.0f, 0.0f, text, (struct overlay_colour){{0}});
    for (int i = 0; i + words.count <= overlay.count && top < 0.0f; i++) {
        bool same = true;
        for (int k = 0; k < words.count && same; k++)
            same = overlay.rectangle[i + k].letter == words.rectangle[k].letter &&
                   overlay.rectangle[i + k].top == overlay.rectangle[i].top;
        if (same)
            top = overlay.rectangle[i].top;
    }
    overlay_close(&words);
    return top;
}

TEST_WITH(the_row_of_the_step_is_visible_and_marked, set_up, NULL)
{
    for (int k = 0; k < STEPS; k++) {
        char heading[64], t[32];
        gather(640, 360, 10, 20, (float)(k + 1));
        snprintf(heading, sizeof heading, "ray of pixel 10, 20: step %d, last 59", k);
        snprintf(t, sizeof t, "%d.500000", k);
        float row = height_of(t), band = -1.0f;
        assert_true(height_of(heading) > 0.0f && row > 0.0f);
        for (int i = 0; i < overlay.count; i++)
            if (coloured(&overlay.rectangle[i], PEN_BAND) &&
                overlay.rectangle[i].left > table()->left)
                band = overlay.rectangle[i].top;
        assert_true(band <= row && band + OVERLAY_LINE > row + 2.0f);
    }
    // If all steps are shown, the last rows are visible and no row is marked.
    gather(640, 360, 10, 20, 0.0f);
    assert_true(height_of("7.37500") > 0.0f && height_of("last steps of pixel 10, 20") > 0.0f);
    for (int i = 0; i < overlay.count; i++)
        assert_false(coloured(&overlay.rectangle[i], PEN_BAND));
}

static void assert_inside(const struct overlay_rectangle *box)
{
    assert_true(box->left >= 0.0f && box->top >= 0.0f &&
                box->right <= pen_picture_width(&overlay) &&
                box->bottom <= pen_picture_height(&overlay));
}

static bool covers(const struct overlay_rectangle *box, float x, float y)
{
    return box != NULL && x > box->left && x < box->right && y > box->top && y < box->bottom;
}

static void assert_apart_from_the_chapter(const struct overlay_rectangle *box)
{
    const struct overlay_rectangle *chapter = &overlay.rectangle[0];
    if (chapter != box)
        assert_true(box->left >= chapter->right || box->top >= chapter->bottom);
}

// The selected pixel is at each point of a grid over the whole picture, for five sizes of the
// picture.
TEST_WITH(the_table_does_not_cover_the_pixel, set_up, NULL)
{
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int k = 0; k < 17 * 9; k++) {
            int width = sizes[i][0], height = sizes[i][1], x = (k % 17) * (width - 1) / 16;
            int y = k / 17 * (height - 1) / 8;
            gather(width, height, x, y, 3.0f);
            const struct overlay_rectangle *box = table();
            assert_true(box != NULL || width < 640);
            float scale = overlay.scale,
                  at[2] = {((float)x + 0.5f) / scale, ((float)(height - y) - 0.5f) / scale};
            assert_false(covers(box, at[0], at[1]));
            if (box == NULL)
                continue;
            assert_inside(box);
            assert_apart_from_the_chapter(box);
        }
}

// The pinned ray starts at each of 12 points, in 24 directions.
TEST_WITH(the_table_does_not_cover_a_ray_seen_from_the_side, set_up, NULL)
{
    probe.pinned = true;
    int shown = 0;
    for (int k = 0; k < 24 * 12; k++) {
        double angle = k % 24 * 3.14159265 / 12.0, from[2] = {60.0 + k / 24 * 45.0, 180.0};
        for (int i = 0; i < STEPS; i++) {
            probe.step[i].pixel[0] = (float)(from[0] + 2.5 * i * cos(angle));
            probe.step[i].pixel[1] = (float)(from[1] + 2.5 * i * sin(angle));
        }
        gather(640, 360, 10, 10, 5.0f);
        const struct overlay_rectangle *box = table();
        shown += box != NULL;
        for (int i = 0; i < STEPS && box != NULL; i++)
            assert_false(covers(box, probe.step[i].pixel[0], 360.0f - probe.step[i].pixel[1]));
    }
    print_message("# the table is visible in %d of 288 cases\n", shown);
    assert_true(shown == 288);
}

TEST_WITH(no_panel_covers_the_ray_of_a_slice_or_plot, set_up, NULL)
{
    for (int view = VIEW_SLICE; view <= VIEW_PLOT; view++)
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            renderer.view = (enum shader_view)view;
            gather(sizes[i][0], sizes[i][1], 10, 10, 4.0f);
            float height = pen_picture_height(&overlay);
            float ray = (view == VIEW_PLOT ? 0.25f : 0.5f) * height;
            assert_true(table() != NULL || sizes[i][0] < 640);
            for (int k = 0; k < overlay.count && sizes[i][0] >= 640; k++)
                assert_true(overlay.rectangle[k].bottom < ray - 20.0f);
            // There is no cross, because the pixel has no position in these views.
            for (int k = 0; k < overlay.count; k++)
                assert_false(coloured(&overlay.rectangle[k], PEN_HERE));
        }
}

// ---- Marks ----

TEST_WITH(a_dot_and_an_arrow_are_on_the_ray, set_up, NULL)
{
    probe.pinned = true;
    for (int k = 0; k < STEPS; k++) {
        probe.step[k].pixel[0] = 100.0f + 5.0f * (float)k;
        probe.step[k].pixel[1] = 200.0f - 1.0f * (float)k;
    }
    for (int row = 0; row < STEPS; row += 7) {
        gather(640, 360, 10, 10, (float)(row + 1));
        int dots = 0, arrows = 0, ways = 0;
        float x = 100.0f + 5.0f * (float)row, y = 160.0f + 1.0f * (float)row;
        for (int i = 0; i < overlay.count; i++) {
            const struct overlay_rectangle *line = &overlay.rectangle[i];
            if (line->width == 0.0f)
                continue;
            bool here = coloured(line, PEN_HERE) && fabsf(line->left - x) < 0.01f &&
                        fabsf(line->top - y) < 0.01f;
            dots += here && line->right == line->left;
            arrows += here && fabsf(line->right - x - 5.0f) < 0.01f &&
                      fabsf(line->bottom - y - 1.0f) < 0.01f;
            ways += coloured(line, PEN_BRIGHT) && line->right > line->left;
        }
        assert_int_equal(dots, 1);
        assert_int_equal(arrows, 1);
        assert_int_equal(ways, row); // a line for each step before the current one
    }
    // A point behind the camera has no position in the picture, so it gets no dot and no arrow.
    probe.step[20].seen = false;
    gather(640, 360, 10, 10, 21.0f);
    for (int i = 0; i < overlay.count; i++)
        assert_false(coloured(&overlay.rectangle[i], PEN_HERE));
}

TESTS(NULL, tear_down)
