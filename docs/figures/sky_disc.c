// sky_disc.c - the share of the sky that is seen is an area: directions of the half-ball, dropped
// on the disc under it; beside it the disc from above with what a ball hides, whole and cut by the
// horizon.
#include <math.h>
#include <stddef.h>

#include "svg.h"

enum { POINTS = 120 };

static const double unit = 150.0, pi = 3.14159265358979323846;

// The outline of what a ball hides on the disc, its middle at an angle from the normal, half its
// width given; what is under the horizon is left out, and the disc's own rim closes it.
static void shadow_on_disc(double x0, double y0, double radius, double angle, double half)
{
    double point[2 * POINTS][2];
    int count = 0;
    double c = cos(angle), s = sin(angle), limit = pi;
    if (c < sin(half))
        limit = acos(-cos(angle) * cos(half) / (sin(angle) * sin(half)));
    for (int i = 0; i < POINTS; i++) {
        double turn = -limit + 2.0 * limit * i / (POINTS - 1);
        // Upwards, away from the normal, and across.
        double away = cos(half) * s - sin(half) * cos(turn) * c, across = sin(half) * sin(turn);
        point[count][0] = x0 + radius * away;
        point[count++][1] = y0 - radius * across;
    }
    if (limit < pi) {
        double rim = acos(cos(half) / s);
        for (int i = 0; i < POINTS; i++) {
            double turn = rim - 2.0 * rim * i / (POINTS - 1);
            point[count][0] = x0 + radius * cos(turn);
            point[count++][1] = y0 - radius * sin(turn);
        }
    }
    svg_polygon(count, (const double(*)[2])point,
                (struct svg_pen){.stroke = SVG_BLUE, .fill = SVG_SKY, .width = 1.8});
}

int main(void)
{
    double x = 200.0, y = 300.0, arc[POINTS][2], angle = 0.7, half = 0.42;
    svg_begin(760.0, 400.0, "The sky dropped on a disc",
              "On the left a half-circle over a floor: a ball hides an arc of it, which dropped "
              "straight down covers a part of the floor's disc. On the right two discs from "
              "above: a ball over the horizon hides an ellipse, one that the horizon cuts hides "
              "a part of an ellipse up to the disc's rim.");
    for (int i = 0; i < POINTS; i++) {
        double turn = pi * i / (POINTS - 1);
        arc[i][0] = x + unit * cos(turn);
        arc[i][1] = y - unit * sin(turn);
    }
    svg_path(POINTS, (const double(*)[2])arc, (struct svg_pen){.stroke = SVG_INK, .width = 1.6});
    svg_line(x - unit, y, x + unit, y, (struct svg_pen){.stroke = SVG_INK, .width = 1.6});
    svg_circle(x + 1.55 * unit * sin(angle) * 0.93, y - 1.55 * unit * cos(angle) * 0.93,
               1.55 * 0.93 * unit * sin(half),
               (struct svg_pen){.stroke = SVG_BLUE, .fill = SVG_SKY, .width = 1.8});
    for (int side = -1; side <= 1; side += 2) {
        double a = angle + side * half, px = x + unit * sin(a), py = y - unit * cos(a);
        svg_line(x, y, x + 1.45 * unit * sin(a), y - 1.45 * unit * cos(a),
                 (struct svg_pen){.stroke = SVG_BLUE, .dash = "5 4"});
        svg_line(px, py, px, y,
                 (struct svg_pen){.stroke = SVG_ORANGE, .dash = "2 4", .width = 2.0});
    }
    svg_line(x + unit * sin(angle - half), y, x + unit * sin(angle + half), y,
             (struct svg_pen){.stroke = SVG_ORANGE, .width = 5.0});
    svg_arrow(x, y, x, y - 0.62 * unit, (struct svg_pen){.stroke = SVG_INK, .width = 1.8});
    svg_text(x - 14.0, y - 0.5 * unit, 'r', 16.0, SVG_INK, "<tspan font-style='italic'>N</tspan>");
    svg_text(x, y + 24.0, 'm', 16.0, SVG_INK, "<tspan font-style='italic'>P</tspan>");
    svg_text(x, y + 62.0, 'm', 15.0, SVG_INK, "from the side");
    for (int k = 0; k < 2; k++) {
        double disc = 80.0, cx = 620.0, cy = 94.0 + 180.0 * k;
        svg_circle(cx, cy, disc, (struct svg_pen){.stroke = SVG_INK, .width = 1.6});
        shadow_on_disc(cx, cy, disc, k == 0 ? angle : 1.35, half);
        svg_circle(cx, cy, 3.0, (struct svg_pen){.fill = SVG_INK});
    }
    svg_text(620.0, y + 92.0, 'm', 15.0, SVG_INK, "from above: over the horizon, cut by it");
    svg_end();
    return 0;
}
