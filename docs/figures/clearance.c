// clearance.c - what one march knows of the angle that is free: a bound from each step, a bound
// from each pair of steps.
#include <math.h>
#include <stddef.h>

#include "svg.h"

static const double unit = 118.0, left = 50.0, axis = 270.0;
static const double thing[3] = {3.05, 1.02, 0.42}; // a ball beside the ray: x, y, radius

static double page_x(double x)
{
    return left + unit * x;
}

static double page_y(double y)
{
    return axis - unit * y;
}

static double distance(double t)
{
    return hypot(thing[0] - t, thing[1]) - thing[2];
}

static void ray(double slope, const char *colour, const char *dash)
{
    double x = 5.6;
    svg_line(page_x(0.0), page_y(0.0), page_x(x), page_y(slope * x),
             (struct svg_pen){.stroke = colour, .width = 2.0, .dash = dash});
}

int main(void)
{
    double t = 0.9, before = 0.0, most = 1.0, least = 10.0, crease[2] = {0.0, 0.0};
    svg_begin(
        760.0, 400.0, "Two bounds of the free angle",
        "A ray to the right with the circles of its march, and a ball beside it. A dashed line "
        "touches the circle that is seen under the smallest angle; a dotted line goes "
        "through the lowest point where two neighbouring circles meet. The line that touches "
        "the ball lies between them.");
    svg_circle(page_x(thing[0]), page_y(thing[1]), unit * thing[2],
               (struct svg_pen){.stroke = SVG_BLUE, .fill = SVG_SKY, .width = 2.0});
    for (int step = 0; step < 8 && t < 5.4; step++) {
        double h = distance(t);
        svg_circle(page_x(t), page_y(0.0), unit * h,
                   (struct svg_pen){.stroke = SVG_INK, .width = 1.1, .opacity = 0.7});
        svg_circle(page_x(t), page_y(0.0), 3.0, (struct svg_pen){.fill = SVG_INK});
        most = fmin(most, h / t);
        if (step > 0) {
            double back = 0.5 * h * h / before, radius = sqrt(h * h - back * back);
            svg_circle(page_x(t - back), page_y(radius), 3.6, (struct svg_pen){.fill = SVG_ORANGE});
            if (radius / (t - back) < least) {
                least = radius / (t - back);
                crease[0] = t - back;
                crease[1] = radius;
            }
        }
        before = h;
        t += h;
    }
    double true_slope = tan(atan2(thing[1], thing[0]) - asin(thing[2] / hypot(thing[0], thing[1])));
    svg_arrow(page_x(0.0), page_y(0.0), page_x(5.75), page_y(0.0),
              (struct svg_pen){.stroke = SVG_INK, .width = 1.6});
    ray(tan(asin(most)), SVG_TEAL, "9 5");
    ray(true_slope, SVG_BLUE, NULL);
    ray(least, SVG_ORANGE, "2 5");
    svg_circle(page_x(crease[0]), page_y(crease[1]), 6.0,
               (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0});
    svg_circle(page_x(0.0), page_y(0.0), 4.5, (struct svg_pen){.fill = SVG_INK});
    svg_text(page_x(0.0), page_y(0.0) + 26.0, 'm', 15.0, SVG_INK, "P");
    svg_text(page_x(5.62), page_y(0.0) + 26.0, 'm', 15.0, SVG_INK, "to the lamp");
    svg_textf(24.0, 346.0, 'l', 15.0, SVG_TEAL, "smallest distance / t: %.1f&#176;",
              asin(most) * 57.29577951308232);
    svg_textf(24.0, 366.0, 'l', 15.0, SVG_BLUE, "the ball: %.1f&#176;",
              atan(true_slope) * 57.29577951308232);
    svg_textf(24.0, 386.0, 'l', 15.0, SVG_ORANGE, "lowest crease: %.1f&#176;",
              atan(least) * 57.29577951308232);
    svg_end();
    return 0;
}
