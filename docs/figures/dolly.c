// dolly.c - chapter 08's passage: the eye goes back and its lens grows longer in proportion, so
// that the framing plane keeps its size while two equal plates, one nearer and one farther, become
// equal.
#include <stdio.h>

#include "svg.h"

// Of the chapter: the depth of the framing plane and half the height seen there; the depths of the
// middles of its two frames. The plates' half height is the figure's own.
static const double framing = 9.5, half_seen = 4.75, near_depth = 6.524, far_depth = 13.799;
static const double half_plate = 1.6;
static const double unit = 16.0, plane_x = 206.0; // pixels a scene unit; where depth 0 is

static double page_x(double depth)
{
    return plane_x + unit * depth;
}

// The height above the axis, at a depth, of the ray that is at the height y on the framing plane.
static double height_at(double u, double y, double depth)
{
    return y * ((1.0 - u) * depth + u * framing) / framing;
}

// From the eye to the camera's plane a ray is dashed: nothing there is in the picture.
static void draw_ray(double u, double middle, double y, double to, const char *colour)
{
    double start = unit * height_at(u, y, 0.0);
    if (u > 0.0 && u < 1.0)
        svg_line(page_x(-framing * u / (1.0 - u)), middle, page_x(0.0), middle - start,
                 (struct svg_pen){.stroke = colour, .width = 1.1, .dash = "3 4"});
    svg_line(page_x(0.0), middle - start, page_x(to), middle - unit * height_at(u, y, to),
             (struct svg_pen){.stroke = colour, .width = 1.3});
}

static void draw_plate(double u, double middle, double depth, const char *colour, double picture_x)
{
    double scale = framing / ((1.0 - u) * depth + u * framing); // against the framing plane's
    for (int side = -1; side <= 1; side += 2)
        draw_ray(u, middle, side * half_plate * scale, depth, colour);
    svg_line(page_x(depth), middle - unit * half_plate, page_x(depth), middle + unit * half_plate,
             (struct svg_pen){.stroke = colour, .width = 7.0});
    double size = unit * half_plate * scale;
    svg_line(picture_x, middle - size, picture_x, middle + size,
             (struct svg_pen){.stroke = colour, .width = 16.0});
    svg_textf(picture_x, middle + unit * half_seen - 9.0, 'm', 13.0, SVG_INK, "%.3f", scale);
}

static void draw_row(double u, double middle, const char *words)
{
    const struct svg_pen thin = {.stroke = SVG_INK, .width = 1.2};
    double top = unit * half_seen;
    for (int side = -1; side <= 1; side += 2)
        draw_ray(u, middle, side * half_seen, framing, SVG_PALE);
    svg_line(page_x(framing), middle - top, page_x(framing), middle + top,
             (struct svg_pen){.stroke = SVG_INK, .width = 3.0});
    double wing = u > 0.0 ? unit * height_at(u, half_seen, 0.0) : 14.0;
    svg_line(page_x(0.0), middle - wing, page_x(0.0), middle + wing,
             (struct svg_pen){.stroke = SVG_INK, .width = 1.2, .dash = "5 4"});
    draw_plate(u, middle, far_depth, SVG_TEAL, 700.0);
    draw_plate(u, middle, near_depth, SVG_ORANGE, 590.0);
    svg_line(645.0, middle - unit * half_plate, 645.0, middle + unit * half_plate,
             (struct svg_pen){.stroke = SVG_INK, .width = 16.0});
    svg_text(645.0, middle + top - 9.0, 'm', 13.0, SVG_INK, "1");
    const double box[4][2] = {
        {548.0, middle - top}, {742.0, middle - top}, {742.0, middle + top}, {548.0, middle + top}};
    svg_polygon(4, box, thin);
    if (u < 1.0)
        svg_circle(page_x(-framing * u / (1.0 - u)), middle, 5.5,
                   (struct svg_pen){.fill = SVG_INK});
    svg_text(24.0, middle - top + 6.0, 'l', 16.0, SVG_INK, words);
    if (u < 1.0)
        svg_text(page_x(-framing * u / (1.0 - u)), middle + 26.0, 'm', 14.0, SVG_INK, "eye");
    else
        svg_text(24.0, middle + 5.0, 'l', 14.0, SVG_INK, "the eye is infinitely far");
}

int main(void)
{
    svg_begin(
        760.0, 610.0, "The passage from perspective to parallel rays",
        "Three rows from the side. The eye stands at the camera, then as far again behind it, then "
        "infinitely far. The rays through the upper and lower edge of the framing plane meet it at "
        "the same places each time. Of two equal plates the nearer one shrinks in the picture from "
        "1.456 to 1.186 to 1, the farther one grows from 0.688 to 0.815 to 1.");
    svg_text(page_x(0.0), 32.0, 'm', 14.0, SVG_INK, "camera's plane");
    svg_text(page_x(framing), 32.0, 'm', 14.0, SVG_INK, "framing plane");
    svg_text(645.0, 32.0, 'm', 14.0, SVG_INK, "in the picture");
    draw_row(0.0, 125.0, "u = 0");
    draw_row(0.5, 315.0, "u = 0.5");
    draw_row(1.0, 505.0, "u = 1");
    svg_end();
    return 0;
}
