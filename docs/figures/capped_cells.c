// capped_cells.c - copies that vary, one asked: a step that swallows a neighbour and the step under
// the cap, from above; and both distances along a row.
#include <math.h>

#include "svg.h"

static const double period = 2.0, reach = 0.62;
static const double half[3][3] = {{0.3, 0.62, 0.4}, {0.55, 0.2, 0.6}, {0.62, 0.35, 0.25}};

static double square(double x, double z, double a)
{
    return hypot(fmax(fabs(x) - a, 0.0), fmax(fabs(z) - a, 0.0));
}

static void box(double x, double z, double a, double unit, struct svg_pen pen)
{
    const double corner[4][2] = {{x - a * unit, z - a * unit},
                                 {x + a * unit, z - a * unit},
                                 {x + a * unit, z + a * unit},
                                 {x - a * unit, z + a * unit}};
    svg_polygon(4, corner, pen);
}

static void draw_plan(void)
{
    const double unit = 47.0, x0 = 180.0, z0 = 196.0;
    for (int i = -1; i <= 1; i++)
        for (int k = -1; k <= 1; k++) {
            double x = x0 + unit * period * i, z = z0 + unit * period * k;
            box(x, z, 1.0, unit, (struct svg_pen){.stroke = SVG_INK, .width = 1.0, .dash = "5 4"});
            box(x, z, reach, unit, (struct svg_pen){.stroke = SVG_PALE, .width = 1.0});
            box(x, z, half[k + 1][i + 1], unit,
                (struct svg_pen){.stroke = SVG_BLUE,
                                 .fill = i == 0 && k == 0 ? SVG_SAND : SVG_SKY});
        }
    const double p[2] = {0.86, 0.24};
    double own = square(p[0], p[1], half[1][1]), cap = period - fmax(p[0], p[1]) - reach;
    double x = x0 + unit * p[0], z = z0 + unit * p[1];
    svg_circle(x, z, unit * own,
               (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0, .dash = "6 4"});
    svg_circle(x, z, unit * cap, (struct svg_pen){.stroke = SVG_TEAL, .width = 2.4});
    svg_circle(x, z, 3.5, (struct svg_pen){.fill = SVG_INK});
    svg_text(x, z - 9.0, 'm', 15.0, SVG_INK, "p");
    svg_text(36.0, 26.0, 'l', 14.0, SVG_ORANGE, "dashed: the own copy's distance;");
    svg_text(36.0, 44.0, 'l', 14.0, SVG_TEAL, "solid: the cap, N &#8722; |x| &#8722; R");
    svg_text(x0, 358.0, 'm', 14.0, SVG_INK, "no copy leaves its pale square, of half width R");
}

// A row of balls at other heights: how far the place (x, 0) is from the ball of cell k.
static const double radius[5] = {0.3, 0.5, 0.2, 0.6, 0.35}, high[5] = {0.9, 0.2, 1.2, 0.3, 0.6};

static double ball(double x, int k)
{
    return hypot(x - period * k, high[k + 2]) - radius[k + 2];
}

static double cap_of(double x, int k)
{
    return period - fabs(x - period * k) - reach;
}

static void draw_row(void)
{
    const struct svg_plot plot = {430.0, 92.0, 300.0, 216.0, {-3.0, 3.0}, {0.0, 1.6}, false, false};
    svg_plot_frame(&plot, 1.0, 0.4, "<tspan font-style='italic'>x</tspan>, along a row",
                   "distance");
    for (int k = -1; k <= 1; k++) {
        double own[61][2], capped[61][2], cap[61][2];
        for (int i = 0; i <= 60; i++) {
            double x = period * (k - 0.5) + 1e-9 + (period - 2e-9) * i / 60.0;
            own[i][0] = capped[i][0] = cap[i][0] = x;
            own[i][1] = ball(x, k);
            cap[i][1] = cap_of(x, k);
            capped[i][1] = fmin(own[i][1], cap[i][1]);
        }
        svg_plot_curve(&plot, 61, (const double(*)[2])cap,
                       (struct svg_pen){.stroke = SVG_PALE, .width = 1.2});
        svg_plot_curve(&plot, 61, (const double(*)[2])own,
                       (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0, .dash = "6 4"});
        svg_plot_curve(&plot, 61, (const double(*)[2])capped,
                       (struct svg_pen){.stroke = SVG_TEAL, .width = 2.6});
    }
    for (int wall = -1; wall <= 1; wall += 2)
        svg_line(svg_plot_x(&plot, wall), plot.top, svg_plot_x(&plot, wall), plot.top + plot.height,
                 (struct svg_pen){.stroke = SVG_INK, .width = 1.0, .dash = "5 4"});
    svg_text(430.0, 26.0, 'l', 14.0, SVG_ORANGE, "dashed: the own copy alone, jumps at walls");
    svg_text(430.0, 44.0, 'l', 14.0, SVG_TEAL, "solid: with the cap, does not jump");
}

int main(void)
{
    svg_begin(
        760.0, 372.0, "A cell, its neighbours, and the cap",
        "Left, from above: three by three cells, a square of its own size in each. From a place "
        "near the wall of the middle cell the circle of the own square's distance contains part "
        "of the neighbour; the circle of the cap ends before it. Right: the distance along a row "
        "of balls. The own ball's jumps at the walls; with the cap, which is the smaller of the "
        "two there, the curve is continuous.");
    draw_plan();
    draw_row();
    svg_end();
    return 0;
}
