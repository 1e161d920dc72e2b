// coarse.c - one cone for a block of pixels: how far it comes between two things, and where the
// pixels' rays begin.
#include <math.h>
#include <stddef.h>

#include "svg.h"

static const double unit = 90.0, left = 140.0, axis = 170.0;
static const double spread = 0.09, margin = 0.03;
static const double things[2][3] = {{1.3, 0.95, 0.35}, {4.7, -0.5, 0.4}}; // x, y, radius

static double page_x(double x)
{
    return left + unit * x;
}

static double page_y(double y)
{
    return axis - unit * y;
}

static double distance(double x, double y)
{
    double nearest = 10.0;
    for (int i = 0; i < 2; i++)
        nearest = fmin(nearest, hypot(things[i][0] - x, things[i][1] - y) - things[i][2]);
    return nearest;
}

// The largest step with (spread (t + h))^2 + h^2 <= (distance - margin)^2, or 0.
static double step_at(double t)
{
    double empty = distance(t, 0.0) - margin, radius = spread * t;
    double a = 1.0 + spread * spread, b = spread * radius;
    return empty > radius ? (sqrt(b * b + a * (empty * empty - radius * radius)) - b) / a : 0.0;
}

int main(void)
{
    svg_begin(760.0, 340.0, "A cone for a block of pixels",
              "From the eye at the left a cone opens to the right, between two balls. Circles "
              "round its axis hold it, each up to the next one's middle, and grow smaller towards "
              "the second "
              "ball. Where the circle is no wider than the cone a bar marks its end; thin rays go "
              "on from there.");
    for (int i = 0; i < 2; i++)
        svg_circle(page_x(things[i][0]), page_y(things[i][1]), unit * things[i][2],
                   (struct svg_pen){.stroke = SVG_BLUE, .fill = SVG_SKY, .width = 2.0});
    double t = 0.0;
    for (int i = 0; i < 64; i++) {
        double h = step_at(t);
        if (h <= 0.002)
            break;
        svg_circle(page_x(t), axis, unit * distance(t, 0.0),
                   (struct svg_pen){.stroke = SVG_INK, .width = 1.1, .opacity = 0.7});
        svg_circle(page_x(t), axis, 3.0, (struct svg_pen){.fill = SVG_INK});
        t += h;
    }
    for (int side = -1; side <= 1; side += 2)
        svg_line(page_x(0.0), axis, page_x(t), page_y(side * spread * t),
                 (struct svg_pen){.stroke = SVG_TEAL, .width = 2.5});
    svg_line(page_x(t), page_y(spread * t), page_x(t), page_y(-spread * t),
             (struct svg_pen){.stroke = SVG_TEAL, .width = 5.0});
    for (int k = -3; k <= 3; k++) {
        double slope = spread * k / 3.5;
        svg_arrow(page_x(t), page_y(slope * t), page_x(6.4), page_y(slope * 6.4),
                  (struct svg_pen){.stroke = SVG_ORANGE, .width = 1.4});
    }
    svg_text(page_x(t) + 6.0, page_y(spread * t) - 66.0, 'm', 15.0, SVG_TEAL, "the cone ends: T");
    svg_text(page_x(6.0), page_y(0.85), 'm', 15.0, SVG_ORANGE, "the pixels&#8217; rays");
    svg_text(page_x(0.0) - 10.0, axis + 24.0, 'm', 15.0, SVG_INK, "eye");
    svg_end();
    return 0;
}
