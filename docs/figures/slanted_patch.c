// slanted_patch.c - Lambert's law: of parallel light a slanted patch catches what passes through
// its projection across the light.
#include <math.h>
#include <stdbool.h>

#include "svg.h"

enum { RAYS = 12 };

static const double radians = 3.14159265358979323846 / 180.0;
static const double half = 84.0, spacing = 14.0; // half a patch, from ray to ray, pixels
static const double top = 76.0, middle_y = 204.0, bottom = 300.0;

// A patch whose normal leans by an angle, and its projection in teal.
static void draw_patch(double x, double angle)
{
    double across = half * cos(angle), down = half * sin(angle);
    svg_line(x - across, middle_y - down, x + across, middle_y + down,
             (struct svg_pen){.stroke = SVG_INK, .width = 6.0});
    svg_line(x - across, top - 14.0, x + across, top - 14.0,
             (struct svg_pen){.stroke = SVG_TEAL, .width = 6.0});
}

// Parallel light from above, and how much of it the patch catches.
static void draw_light(double middle, double degrees, const char *words)
{
    double angle = degrees * radians, reach = half * cos(angle);
    int caught = 0;
    for (int i = 0; i < RAYS; i++) {
        double x = spacing * (i - 0.5 * (RAYS - 1));
        bool meets = fabs(x) < reach;
        caught += meets;
        svg_arrow(
            middle + x, top, middle + x,
            meets ? middle_y + x * tan(angle) - 3.5 / cos(angle) : bottom,
            (struct svg_pen){.stroke = meets ? SVG_ORANGE : SVG_PALE, .width = meets ? 2.0 : 1.2});
    }
    draw_patch(middle, angle);
    svg_text(middle, 30.0, 'm', 15.0, SVG_INK, words);
    svg_textf(middle, bottom + 34.0, 'm', 15.0, SVG_ORANGE, "%d of %d rays", caught, RAYS);
}

static void draw_angle(double x, double y, double radius, double from, double to)
{
    double arc[24][2];
    for (int i = 0; i < 24; i++) {
        double angle = from + (to - from) * i / 23.0;
        arc[i][0] = x + radius * cos(angle);
        arc[i][1] = y - radius * sin(angle);
    }
    svg_path(24, (const double(*)[2])arc, (struct svg_pen){.stroke = SVG_BLUE, .width = 1.8});
}

// The two lengths and the angle that stands in both places.
static void draw_lengths(double x)
{
    const double angle = 48.0 * radians, quarter = 90.0 * radians;
    double c = cos(angle), s = sin(angle);
    for (int side = -1; side <= 1; side += 2)
        svg_line(x + side * half * c, top - 6.0, x + side * half * c, middle_y + side * half * s,
                 (struct svg_pen){.stroke = SVG_TEAL, .width = 1.2, .dash = "5 4"});
    svg_line(x - half * c, middle_y - half * s, x + half * c, middle_y - half * s,
             (struct svg_pen){.stroke = SVG_PALE, .width = 1.2});
    draw_patch(x, angle);
    svg_arrow(x, middle_y, x, middle_y - 96.0,
              (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.4});
    svg_arrow(x, middle_y, x + 96.0 * s, middle_y - 96.0 * c,
              (struct svg_pen){.stroke = SVG_BLUE, .width = 2.4});
    draw_angle(x, middle_y, 34.0, quarter - angle, quarter);
    draw_angle(x - half * c, middle_y - half * s, 34.0, -angle, 0.0);
    svg_text(x + 18.0, middle_y - 42.0, 'm', 15.0, SVG_BLUE, "&#952;");
    svg_text(x - half * c + 44.0, middle_y - half * s + 23.0, 'm', 15.0, SVG_BLUE, "&#952;");
    svg_text(x - 10.0, middle_y - 82.0, 'r', 15.0, SVG_ORANGE, "L");
    svg_text(x + 96.0 * s + 8.0, middle_y - 96.0 * c + 2.0, 'l', 15.0, SVG_BLUE, "N");
    svg_text(x + 6.0, middle_y + 36.0, 'r', 15.0, SVG_INK, "A");
    svg_text(x, 30.0, 'm', 15.0, SVG_TEAL, "A cos &#952;");
    svg_text(x, bottom + 34.0, 'm', 15.0, SVG_INK, "cos &#952; = N &#183; L");
}

int main(void)
{
    svg_begin(
        760.0, 356.0, "A patch that leans catches less light",
        "Parallel light falls on three patches of equal size. One faces the light and catches "
        "all twelve rays. One leans by 60 degrees and catches six; the others pass beside it. "
        "The third shows why: across the light its width A becomes A times the cosine of the "
        "angle between its normal N and the direction L of the light.");
    draw_light(130.0, 0.0, "faces the light");
    draw_light(370.0, 60.0, "leans by 60&#176;");
    draw_lengths(610.0);
    svg_end();
    return 0;
}
