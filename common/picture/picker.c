#include "picture/picker.h"

#include <math.h>
#include <string.h>

#include "picture/colour.h"
#include "picture/pen.h"

#define SIDE   72.0f // largest side of the square, units
#define LEAST  24.0f // smallest side of the square, units
#define BAR    12.0f // width of the bar of hues
#define GAP    6.0f
#define APART  4.0f                             // distance from the panel
#define BEYOND (2.0f * PEN_PADDING + GAP + BAR) // the picker's width without the square

// ---- Position ----

static float clamp(float value, float low, float high)
{
    return fmaxf(low, fminf(value, high));
}

// Find the first and the last row of the selected colour. Returns false if there are none.
static bool find_rows(const struct panel_rows *rows, const struct panel_row *ends[2])
{
    ends[0] = ends[1] = NULL;
    for (int i = 0; i < rows->count; i++) {
        const struct panel_row *row = &rows->row[i];
        if (!row->selected)
            continue;
        ends[0] = ends[0] != NULL || row->swatch <= 0.0f ? ends[0] : row;
        ends[1] = row;
    }
    return ends[0] != NULL;
}

// Make the picker as large as its room allows.
//   width, height  size of the room, units
static void size_for(struct picker *picker, float width, float height)
{
    float side = fminf(width - BEYOND, height - 2.0f * PEN_PADDING);
    picker->side = floorf(clamp(side, LEAST, SIDE));
    picker->width = picker->side + BEYOND;
    picker->height = picker->side + 2.0f * PEN_PADDING;
}

void picker_place(struct picker *picker, const struct panel_rows *rows,
                  const struct overlay *overlay)
{
    const struct panel_row *row[2];
    float right = pen_picture_width(overlay) - PEN_MARGIN;
    float low = pen_picture_height(overlay) - PEN_MARGIN;
    picker->width = picker->height = 0.0f;
    if (!find_rows(rows, row))
        return;
    float above = row[0]->top - 2.0f, below = row[1]->top + row[1]->height;
    float behind = rows->left + rows->width + APART;
    size_for(picker, right - PEN_MARGIN, low - PEN_MARGIN);
    picker->left = behind;
    picker->top = above;
    if (behind + picker->width > right)
        picker->left = rows->left - APART - picker->width;
    if (picker->left < PEN_MARGIN) { // over the panel, below or above the colour's rows
        bool under = low - below >= above - PEN_MARGIN;
        size_for(picker, right - PEN_MARGIN, under ? low - below : above - PEN_MARGIN);
        picker->left = row[0]->left;
        picker->top = under ? below : above - picker->height;
    }
    picker->left = fmaxf(0.0f, fminf(picker->left, right - picker->width));
    picker->top = fmaxf(0.0f, fminf(picker->top, low - picker->height));
}

bool picker_holds(const struct picker *picker, float x, float y)
{
    return x >= picker->left && x < picker->left + picker->width && y >= picker->top &&
           y < picker->top + picker->height;
}

// Find the position of a point relative to the square's bottom left, as fractions of the square's
// side. Returns the part that contains the point.
static enum picker_part look_up(const struct picker *picker, float x, float y, float at[2])
{
    at[0] = (x - picker->left - PEN_PADDING) / picker->side;
    at[1] = 1.0f - (y - picker->top - PEN_PADDING) / picker->side;
    float middle = 1.0f + 0.5f * GAP / picker->side;
    return at[0] < middle ? PICKER_SQUARE : PICKER_BAR;
}

enum picker_part picker_at(const struct picker *picker, float x, float y)
{
    float at[2];
    return picker_holds(picker, x, y) ? look_up(picker, x, y, at) : PICKER_NOTHING;
}

void picker_drag(struct picker *picker, enum picker_part part, float x, float y)
{
    float at[2];
    look_up(picker, x, y, at);
    for (int i = 0; i < 2; i++)
        at[i] = clamp(at[i], 0.0f, 1.0f);
    if (part == PICKER_SQUARE) {
        picker->hsv[1] = (double)at[0];
        picker->hsv[2] = (double)at[1];
    } else if (part == PICKER_BAR)
        picker->hsv[0] = (double)at[1];
}

// ---- The colour ----

void picker_take(struct picker *picker, const struct parameter *colour)
{
    double number[3];
    bool is_new = false;
    for (int k = 0; k < 3; k++)
        is_new |= picker->value[k] != colour->value[k];
    if (!is_new)
        return;
    for (int k = 0; k < 3; k++)
        number[k] = colour_encode(parameter_fraction(colour, k));
    colour_hue_of(number, picker->hsv);
    memcpy(picker->value, colour->value, sizeof picker->value);
}

void picker_give(struct picker *picker, struct parameter *colour)
{
    double number[3];
    colour_of_hue(picker->hsv, number);
    for (int k = 0; k < 3; k++)
        parameter_put(colour, k, colour_decode(number[k]));
    memcpy(picker->value, colour->value, sizeof picker->value);
}

// ---- Drawing ----

static struct overlay_colour shown(double hue, double saturation, double value)
{
    const double hsv[3] = {hue, saturation, value};
    struct overlay_colour colour = {{0, 0, 0, 255}};
    double number[3];
    colour_of_hue(hsv, number);
    for (int k = 0; k < 3; k++)
        colour.channel[k] = (unsigned char)lround(255.0 * number[k]);
    return colour;
}

static struct overlay_colour thin(unsigned char grey, double opacity)
{
    return (struct overlay_colour){{grey, grey, grey, (unsigned char)lround(255.0 * opacity)}};
}

// A colour is v (1 + s (hue - 1)): the hue, covered with white that fades to the right, and then
// with black that fades upwards. Strips are whole pixels wide, so they do not overlap.
static void draw_square(const struct picker *picker, struct overlay *overlay)
{
    float scale = overlay->scale, pixel = 1.0f / scale;
    float left = roundf(scale * (picker->left + PEN_PADDING)) * pixel;
    float top = roundf(scale * (picker->top + PEN_PADDING)) * pixel;
    int count = (int)roundf(scale * picker->side);
    float side = (float)count * pixel;
    overlay_box(overlay, left, top, side, side, shown(picker->hsv[0], 1.0, 1.0));
    for (int i = 0; i < count; i++)
        overlay_box(overlay, left + (float)i * pixel, top, pixel, side,
                    thin(255, 1.0 - (i + 0.5) / count));
    for (int i = 0; i < count; i++)
        overlay_box(overlay, left, top + (float)i * pixel, side, pixel, thin(0, (i + 0.5) / count));
    for (int i = 0; i < count; i++)
        overlay_box(overlay, left + side + GAP, top + (float)i * pixel, BAR, pixel,
                    shown(1.0 - (i + 0.5) / count, 1.0, 1.0));
}

// Draw a bright ring with dark edges around the colour, and a line at its hue.
static void draw_marks(const struct picker *picker, struct overlay *overlay)
{
    float left = picker->left + PEN_PADDING, top = picker->top + PEN_PADDING, side = picker->side;
    const float at[2] = {left + side * (float)picker->hsv[1],
                         top + side * (1.0f - (float)picker->hsv[2])};
    overlay_line(overlay, at, at, 9.0f, PEN_DARK);
    overlay_line(overlay, at, at, 7.0f, PEN_BRIGHT);
    overlay_line(overlay, at, at, 5.0f, shown(picker->hsv[0], picker->hsv[1], picker->hsv[2]));
    float y = top + side * (1.0f - (float)picker->hsv[0]), x = left + side + GAP - 2.0f;
    overlay_box(overlay, x, y - 1.5f, BAR + 4.0f, 3.0f, PEN_DARK);
    overlay_box(overlay, x, y - 0.5f, BAR + 4.0f, 1.0f, PEN_BRIGHT);
}

void picker_draw(const struct picker *picker, struct overlay *overlay)
{
    if (picker->width <= 0.0f)
        return;
    // The picker may cover text of the panel, so its background is darker than the panel's.
    overlay_box(overlay, picker->left, picker->top, picker->width, picker->height, PEN_DARK);
    pen_open(overlay, picker->left, picker->top, picker->width - 2.0f * PEN_PADDING,
             picker->height - 2.0f * PEN_PADDING);
    draw_square(picker, overlay);
    draw_marks(picker, overlay);
}
