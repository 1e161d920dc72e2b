// picker.c - tests the colour picker: how colours are converted, that the picker shows the colours
// that it sets, which of its parts is at a point, and which rows of a panel have a swatch.
#include "lib/test.h"
#include "picture/colour.h"
#include "picture/panel.h"
#include "picture/picker.h"

static struct overlay overlay;
static struct panel_rows rows;
static struct parameter parameters[] = {
    {.name = "size", .components = 1, .maximum = 8.0, .unit = "metres"},
    {.name = "lamp", .components = 3, .maximum = 4.0, .unit = "linear RGB"},
    {.name = "wide", .components = 1, .maximum = 9.0, .unit = "feet"},
};
static struct renderer renderer = {.parameters = {.item = parameters, .count = 3}};

static int close_all(void **unused)
{
    (void)unused;
    overlay_close(&overlay);
    panel_rows_free(&rows);
    return 0;
}

static void assert_near(double a, double b, double most)
{
    if (!(fabs(a - b) <= most))
        fail_msg("%.9g is not %.9g", a, b);
}

// The table contains the six hues at corners of the RGB cube, a grey, and a colour that was
// converted by hand.
TEST(a_hue_is_a_colour)
{
    static const double table[][6] = {{0, 1, 1, 1, 0, 0},         {1.0 / 6, 1, 1, 1, 1, 0},
                                      {2.0 / 6, 1, 1, 0, 1, 0},   {0.5, 1, 1, 0, 1, 1},
                                      {4.0 / 6, 1, 1, 0, 0, 1},   {5.0 / 6, 1, 1, 1, 0, 1},
                                      {0, 0, 0.5, 0.5, 0.5, 0.5}, {0.25, 0.5, 0.8, 0.6, 0.8, 0.4}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double rgb[3], hsv[3] = {0};
        colour_of_hue(table[i], rgb);
        colour_hue_of(&table[i][3], hsv);
        for (int k = 0; k < 3; k++) {
            assert_near(rgb[k], table[i][3 + k], 1e-12);
            assert_near(hsv[k], table[i][k], 1e-12);
        }
    }
}

TEST(encoding_reverses_decoding)
{
    assert_near(colour_decode(0.5), 0.21404114, 1e-8);
    assert_near(colour_encode(0.18), 0.46135613, 1e-8);
    for (int i = 0; i <= 255; i++)
        assert_near(colour_encode(colour_decode(i / 255.0)), i / 255.0, 1e-6);
}

// Each of 9 x 9 x 9 colours comes back without the rounding errors of the conversion, because
// picker_give rounds values to about a thousandth of their range.
TEST(a_colour_that_is_taken_is_given_back)
{
    struct parameter *lamp = &parameters[1];
    for (int i = 0; i < 9 * 9 * 9; i++) {
        struct picker picker = {.value = {-1.0}};
        const double value[3] = {i % 9 * 0.5, i / 9 % 9 * 0.5, i / 81 * 0.5};
        memcpy(lamp->value, value, sizeof value);
        picker_take(&picker, lamp);
        picker_give(&picker, lamp);
        for (int k = 0; k < 3; k++)
            assert_near(lamp->value[k], value[k], 1e-12);
    }
}

// A colour that is dragged to black and back keeps its hue. A new value of the parameter replaces
// the hue.
TEST(a_hue_outlives_grey)
{
    struct parameter *lamp = &parameters[1];
    struct picker picker = {.side = 50.0f, .width = 100.0f, .value = {-1.0}};
    const double blue[3] = {0.0, 0.0, 4.0}, red[3] = {4.0, 0.0, 0.0};
    memcpy(lamp->value, blue, sizeof blue);
    picker_take(&picker, lamp);
    picker_drag(&picker, PICKER_SQUARE, -500.0f, 500.0f);
    picker_give(&picker, lamp);
    for (int k = 0; k < 3; k++)
        assert_true(lamp->value[k] == 0.0);
    picker_take(&picker, lamp);
    picker_drag(&picker, PICKER_SQUARE, 500.0f, -500.0f);
    picker_give(&picker, lamp);
    for (int k = 0; k < 3; k++)
        assert_true(lamp->value[k] == blue[k]);
    memcpy(lamp->value, red, sizeof red);
    picker_take(&picker, lamp);
    assert_true(picker.hsv[0] == 0.0);
}

// The colour that is drawn at a position is the colour that a press there chooses.
TEST(the_square_shows_the_colours_that_it_sets)
{
    struct picker picker = {
        .hsv = {0.6, 0.0, 1.0}, .left = 10, .top = 20, .width = 104, .height = 86, .side = 72};
    overlay_begin(&overlay, 640, 360, 1.5f);
    picker_draw(&picker, &overlay);
    for (int i = 0; i < 36; i++) {
        float x = 17.5f + 2.0f * (float)i, y = 27.5f + 60.0f * (float)(i % 7) / 7.0f;
        double shown[3] = {0}, rgb[3];
        // Blend all boxes at the position, except the last five, which mark the chosen colour.
        for (int k = 0; k < overlay.count - 5; k++) {
            const struct overlay_rectangle *r = &overlay.rectangle[k];
            double share = r->colour.channel[3] / 255.0;
            bool over = x >= r->left && x < r->right && y >= r->top && y < r->bottom;
            for (int c = 0; c < 3 && over; c++)
                shown[c] += share * (r->colour.channel[c] / 255.0 - shown[c]);
        }
        assert_true(picker_at(&picker, x, y) == PICKER_SQUARE);
        picker_drag(&picker, PICKER_SQUARE, x, y);
        colour_of_hue(picker.hsv, rgb);
        for (int c = 0; c < 3; c++)
            assert_near(shown[c], rgb[c], 0.015);
    }
    assert_true(picker_at(&picker, 101.0f, 30.0f) == PICKER_BAR);
    assert_true(picker_at(&picker, 115.0f, 30.0f) == PICKER_NOTHING);
    picker_drag(&picker, PICKER_BAR, 0.0f, 20.0f + 7.0f + 18.0f);
    assert_near(picker.hsv[0], 0.75, 1e-6);
}

// Only the first row of a colour has a swatch. If the colour's rows are not shown, neither is the
// picker.
TEST(only_a_colour_has_a_swatch)
{
    struct picker picker = {.width = 1.0f};
    struct panel panel = {.renderer = &renderer,
                          .title = "A title",
                          .selected = &parameters[1],
                          .pixel = {-1, -1},
                          .picker = &picker,
                          .rows = &rows};
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    int count = 0;
    for (int i = 0; i < rows.count; i++) {
        const struct panel_row *row = &rows.row[i];
        count += row->swatch > 0.0f;
        assert_true((row->swatch > 0.0f) == (row->parameter == 1 && row->part < 0 && count == 1 &&
                                             row->kind == PANEL_ROW_PARAMETER));
        assert_true(panel_row_is_swatch(row, row->left + row->swatch + 5.0f) ==
                    (row->swatch > 0.0f));
        assert_false(panel_row_is_swatch(row, row->left + row->swatch + 15.0f));
    }
    assert_int_equal(count, 1);
    float wide = rows.width;
    const double many[3] = {0.123, 3.456, 1.234};
    memcpy(parameters[1].value, many, sizeof many);
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(rows.width == wide); // the panel keeps its width while a colour is dragged
    panel.rolled = true;
    panel_gather(&panel, &overlay, 640, 360, 1.0f);
    assert_true(picker.width == 0.0f);
}

TESTS(NULL, close_all)
