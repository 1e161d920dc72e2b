// relaxed.c - longer steps along a ray: two balls that overlap, then a gap, and the way back.
#include <stddef.h>

#include "svg.h"

static const double unit = 130.0, left = 40.0, axis = 165.0;

static double page_x(double x)
{
    return left + unit * x;
}

static void ball(double t, double d, const char *colour, const char *dash)
{
    svg_circle(page_x(t), axis, unit * d,
               (struct svg_pen){.stroke = colour, .width = 2.0, .dash = dash});
    svg_circle(page_x(t), axis, 4.0, (struct svg_pen){.fill = colour});
}

int main(void)
{
    const double omega = 1.6, t0 = 0.9, d0 = 0.9;
    const double t1 = t0 + omega * d0, d1 = 0.78, covered = t1 + d1;
    const double t2 = t1 + omega * d1, d2 = 0.28;
    svg_begin(760.0, 340.0, "Longer steps, and a way back",
              "A ray to the right with four balls. The second overlaps the first a little. The "
              "third, dashed, begins behind the end of the second: between them is a gap, in "
              "which a post stands. A fourth ball stands at the end of the second.");
    svg_line(page_x(covered + 0.09), axis - 46.0, page_x(covered + 0.09), axis + 46.0,
             (struct svg_pen){.stroke = SVG_BLUE, .width = 7.0});
    svg_arrow(page_x(0.0), axis, page_x(5.4), axis, (struct svg_pen){.stroke = SVG_INK});
    ball(t0, d0, SVG_INK, NULL);
    ball(t1, d1, SVG_INK, NULL);
    ball(t2, d2, SVG_ORANGE, "6 4");
    ball(covered, 0.08, SVG_TEAL, NULL);
    svg_text(page_x(t0), axis + 24.0, 'm', 15.0, SVG_INK, "1");
    svg_text(page_x(t1), axis + 24.0, 'm', 15.0, SVG_INK, "2");
    svg_text(page_x(t2) + 20.0, axis + 60.0, 'm', 15.0, SVG_ORANGE, "3: too far");
    svg_text(page_x(covered) + 6.0, axis + 88.0, 'm', 15.0, SVG_TEAL, "4: back");
    svg_text(page_x(covered) + 12.0, axis - 62.0, 'l', 15.0, SVG_BLUE, "a post in the gap");
    svg_line(page_x(0.0), 310.0, page_x(covered), 310.0,
             (struct svg_pen){.stroke = SVG_TEAL, .width = 5.0});
    svg_line(page_x(covered), 310.0, page_x(t2 - d2), 310.0,
             (struct svg_pen){.stroke = SVG_ORANGE, .width = 5.0, .dash = "3 3"});
    svg_text(page_x(2.0), 332.0, 'm', 15.0, SVG_TEAL, "covered: surely free");
    svg_text(page_x(covered) - 4.0, 332.0, 'l', 15.0, SVG_ORANGE, "not known");
    svg_end();
    return 0;
}
