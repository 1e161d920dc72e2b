// crossing.c - where marches towards a wall end within the width of a pixel: plain ones from many
// starts, and the one that looks for where it enters.
#include <stddef.h>

#include "svg.h"

static const double width = 0.1, slant = 0.5, shorter = 0.7; // the threshold; sine of 30 degrees

// Distance to the wall, which stands at t = 0.
static double distance(double t)
{
    return -slant * t;
}

int main(void)
{
    const struct svg_plot plot = {70.0, 30.0, 650.0, 260.0, {-0.5, 0.0}, {0.0, 0.25}, false, false};
    const double line[2][2] = {{-0.5, 0.25}, {0.0, 0.0}},
                 edge[2][2] = {{-0.5, width}, {0.0, width}};
    svg_begin(
        760.0, 350.0, "Where marches end",
        "The distance to a wall falls along a straight line to 0. Where it is below a level "
        "line, the threshold, sixteen plain marches have ended, at as many places. Another march "
        "stepped in by a little and went back to where the two lines cross.");
    svg_plot_frame(&plot, 0.1, 0.05, "place on the ray; the wall stands at 0", "distance");
    svg_plot_curve(&plot, 2, line, (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    svg_plot_curve(&plot, 2, edge,
                   (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0, .dash = "6 4"});
    for (int i = 0; i < 16; i++) {
        double t = -3.0 - 0.1875 * i;
        while (distance(t) >= width)
            t += distance(t);
        svg_circle(svg_plot_x(&plot, t), svg_plot_y(&plot, distance(t)), 4.0,
                   (struct svg_pen){.fill = SVG_ORANGE, .opacity = 0.8});
    }
    double before = -0.24, step = distance(before) - shorter * width, t = before + step;
    double missing = distance(before) - width, under = distance(t) - width;
    double place = t + step * under / (missing - under);
    double at[3] = {before, t, place};
    for (int i = 0; i < 3; i++)
        svg_circle(
            svg_plot_x(&plot, at[i]), svg_plot_y(&plot, distance(at[i])), i == 2 ? 7.0 : 4.0,
            (struct svg_pen){.fill = i == 2 ? SVG_TEAL : NULL, .stroke = SVG_TEAL, .width = 2.0});
    double y = svg_plot_y(&plot, 0.15);
    svg_arrow(svg_plot_x(&plot, before), y, svg_plot_x(&plot, t), y,
              (struct svg_pen){.stroke = SVG_TEAL, .width = 2.0});
    svg_arrow(svg_plot_x(&plot, t), y + 14.0, svg_plot_x(&plot, place), y + 14.0,
              (struct svg_pen){.stroke = SVG_TEAL, .width = 2.0});
    svg_text(svg_plot_x(&plot, -0.18), y + 5.0, 'l', 15.0, SVG_TEAL, "a short step in, and back");
    svg_text(svg_plot_x(&plot, -0.49), svg_plot_y(&plot, width) - 8.0, 'l', 15.0, SVG_BLUE,
             "the threshold <tspan font-style='italic'>r</tspan>");
    svg_text(svg_plot_x(&plot, -0.19), svg_plot_y(&plot, 0.045), 'r', 15.0, SVG_ORANGE,
             "plain marches, from sixteen starts");
    svg_end();
    return 0;
}
