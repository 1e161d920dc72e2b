// thin_lens.c - rays from all over a lens: they meet in the plane in focus; a point behind it
// becomes a disc.
#include <stddef.h>

#include "svg.h"

// Lengths in pixels along the view: the lens at 0, the plane in focus, a point beyond it.
static const double eye = 90.0, middle = 170.0, focus = 330.0, depth = 560.0, radius = 70.0;

// Where the line from the lens at the height `from` to the point (depth, at) is at x.
static double height_at(double from, double at, double x)
{
    return from + (at - from) * x / depth;
}

int main(void)
{
    const double points[2] = {50.0, -60.0}; // one in focus, one behind
    svg_begin(760.0, 360.0, "Rays through a thin lens",
              "From the left a lens, the plane in focus and a point behind it. Rays from the rim "
              "and the middle of "
              "the lens to a point of the plane in focus meet there; those to the point behind "
              "cross the plane in "
              "a segment of the length c, the circle of confusion.");
    svg_line(20.0, middle, 740.0, middle, (struct svg_pen){.stroke = SVG_PALE, .dash = "6 5"});
    svg_line(eye + focus, 30.0, eye + focus, 310.0,
             (struct svg_pen){.stroke = SVG_INK, .width = 1.6});
    for (int i = -1; i <= 1; i++) {
        double from = i * radius;
        svg_line(eye, middle - from, eye + focus, middle - points[0],
                 (struct svg_pen){.stroke = SVG_TEAL, .width = 1.8});
        svg_line(eye, middle - from, eye + depth, middle - points[1],
                 (struct svg_pen){.stroke = SVG_ORANGE, .width = 1.8});
    }
    svg_line(eye, middle - radius, eye, middle + radius,
             (struct svg_pen){.stroke = SVG_BLUE, .width = 6.0});
    svg_circle(eye + focus, middle - points[0], 6.0, (struct svg_pen){.fill = SVG_TEAL});
    svg_circle(eye + depth, middle - points[1], 6.0, (struct svg_pen){.fill = SVG_ORANGE});
    double low = height_at(-radius, points[1], focus), high = height_at(radius, points[1], focus);
    svg_line(eye + focus, middle - low, eye + focus, middle - high,
             (struct svg_pen){.stroke = SVG_ORANGE, .width = 6.0});
    svg_text(eye + focus + 14.0, middle - low + 24.0, 'l', 17.0, SVG_ORANGE,
             "<tspan font-style='italic'>c</tspan>");
    svg_text(eye - 16.0, middle - 0.6 * radius, 'r', 17.0, SVG_BLUE,
             "<tspan font-style='italic'>R</tspan>");
    svg_text(eye + focus + 14.0, middle - points[0] - 12.0, 'l', 15.0, SVG_TEAL,
             "in focus: one point");
    svg_text(eye + depth + 14.0, middle - points[1] + 26.0, 'm', 15.0, SVG_ORANGE,
             "behind: a disc");
    svg_arrow(eye, 336.0, eye + focus, 336.0, (struct svg_pen){.stroke = SVG_INK});
    svg_text(eye + 0.5 * focus, 328.0, 'm', 15.0, SVG_INK,
             "focus <tspan font-style='italic'>s</tspan>");
    svg_arrow(eye, 20.0, eye + depth, 20.0, (struct svg_pen){.stroke = SVG_INK});
    svg_text(eye + 0.25 * depth, 40.0, 'm', 15.0, SVG_INK,
             "depth <tspan font-style='italic'>d</tspan>");
    svg_end();
    return 0;
}
