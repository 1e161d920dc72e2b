// five_taps.c - five distances along the normal: a floor before a wall, and the same numbers in a
// shaft; the ball of one tap and the cone in which it proves something.
#include <math.h>
#include <stddef.h>

#include "svg.h"

static const double unit = 62.0, ground = 360.0, pi = 3.14159265358979323846;

static double page_y(double y)
{
    return ground - unit * y;
}

// Floor and walls.
static void solid(double x0, double y0, double x1, double y1)
{
    const double corner[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    svg_polygon(4, corner, (struct svg_pen){.fill = SVG_PALE, .opacity = 0.55});
}

// The taps over a point, each with its empty ball: the nearest thing is a wall, away on the left.
static void taps(double x, double away)
{
    for (int i = 0; i < 5; i++) {
        double height = 5.0 / pow(2.0, 4 - i), distance = fmin(height, away);
        svg_circle(x, page_y(height), unit * distance,
                   (struct svg_pen){.stroke = SVG_BLUE, .width = 1.3});
        svg_circle(x, page_y(height), 3.2, (struct svg_pen){.fill = SVG_INK});
    }
    svg_line(x, page_y(0.0), x, page_y(5.3), (struct svg_pen){.stroke = SVG_INK, .dash = "4 4"});
    svg_circle(x, page_y(0.0), 4.5, (struct svg_pen){.fill = SVG_ORANGE});
}

int main(void)
{
    double away = 0.75, left = 160.0, middle = 400.0, right = 640.0;
    svg_begin(
        760.0, 430.0, "Five taps along the normal",
        "Three drawings. A point of a floor beside one wall, with five taps over it and the "
        "empty ball of each. The same taps between two walls. One tap over a "
        "small thing beside the normal, and the cone in which the tap proves that something is.");
    solid(30.0, ground, 270.0, ground + 26.0);
    solid(left - unit * away - 42.0, 20.0, left - unit * away, ground);
    taps(left, away);
    solid(300.0, ground, 500.0, ground + 26.0);
    solid(middle - unit * away - 42.0, 20.0, middle - unit * away, ground);
    solid(middle + unit * away, 20.0, middle + unit * away + 42.0, ground);
    taps(middle, away);
    double height = 3.0, distance = 1.35, half = asin(distance / height);
    solid(530.0, ground, 740.0, ground + 26.0);
    for (int side = -1; side <= 1; side += 2)
        svg_line(right, page_y(0.0), right + side * unit * 4.1 * sin(half), page_y(4.1 * cos(half)),
                 (struct svg_pen){.stroke = SVG_ORANGE, .width = 1.6, .dash = "7 4"});
    svg_circle(right, page_y(height), unit * distance,
               (struct svg_pen){.stroke = SVG_BLUE, .fill = SVG_SKY, .width = 1.6});
    double turn = 0.9 * pi, x = right + unit * distance * cos(turn),
           y = page_y(height + distance * sin(turn));
    svg_circle(x - 5.0 * -cos(turn), y, 6.0, (struct svg_pen){.fill = SVG_INK});
    svg_line(right, page_y(0.0), right, page_y(height), (struct svg_pen){.stroke = SVG_INK});
    svg_line(right, page_y(height), x, y, (struct svg_pen){.stroke = SVG_INK});
    svg_circle(right, page_y(height), 3.2, (struct svg_pen){.fill = SVG_INK});
    svg_circle(right, page_y(0.0), 4.5, (struct svg_pen){.fill = SVG_ORANGE});
    svg_text(right + 10.0, page_y(1.1), 'l', 16.0, SVG_INK, "<tspan font-style='italic'>h</tspan>");
    svg_text(right - 26.0, page_y(height) - 18.0, 'm', 16.0, SVG_INK,
             "<tspan font-style='italic'>d</tspan>");
    svg_text(left, 412.0, 'm', 15.0, SVG_INK, "one wall: more than half is seen");
    svg_text(middle, 412.0, 'm', 15.0, SVG_INK, "walls all round: little");
    svg_text(right, 412.0, 'm', 15.0, SVG_INK, "what one tap proves");
    svg_end();
    return 0;
}
