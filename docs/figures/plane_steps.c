// plane_steps.c - the number of steps to a plane against the angle at which a ray meets it, and the
// number of steps past a ball against the width of the gap.
#include <math.h>
#include <stddef.h>

#include "svg.h"

static const double radians = 3.14159265358979323846 / 180.0;

// The number of evaluations in a march from height 1 above a plane. Each step multiplies the height
// by 1 - sin(angle).
static double plane_steps(double degrees, double threshold)
{
    return ceil(log(threshold) / log(1.0 - sin(degrees * radians))) + 1.0;
}

// The number of steps past a ball of radius 1, which the ray misses by delta, from 3 units before
// the point closest to the ball to 3 units after that point.
static double ball_moves(double delta)
{
    int moves = 0;
    for (double t = -3.0; t < 3.0; moves++)
        t += hypot(t, 1.0 + delta) - 1.0;
    return moves;
}

static void draw_plane(void)
{
    const struct svg_plot plot = {70.0,         50.0,           270.0, 270.0,
                                  {0.1, 100.0}, {1.0, 10000.0}, true,  true};
    svg_plot_frame(&plot, 0.0, 0.0, "angle to the plane, degrees", "steps");
    const double thresholds[2] = {0.01, 0.0005};
    for (int k = 0; k < 2; k++) {
        double curve[300][2];
        for (int i = 0; i < 300; i++) {
            curve[i][0] = 0.1 * pow(880.0, i / 299.0);
            curve[i][1] = plane_steps(curve[i][0], thresholds[k]);
        }
        svg_plot_curve(&plot, 300, (const double(*)[2])curve,
                       (struct svg_pen){.stroke = k == 0 ? SVG_ORANGE : SVG_BLUE,
                                        .width = 2.4,
                                        .dash = k == 0 ? "7 4" : NULL});
    }
    double limit = svg_plot_y(&plot, 256.0);
    svg_line(plot.left, limit, plot.left + plot.width, limit,
             (struct svg_pen){.stroke = SVG_INK, .width = 1.0, .dash = "2 3"});
    svg_text(plot.left + plot.width - 4.0, limit - 6.0, 'r', 13.0, SVG_INK, "maxSteps 256");
    svg_text(170.0, 112.0, 'l', 14.0, SVG_BLUE, "threshold 0.0005");
    svg_text(96.0, 238.0, 'l', 14.0, SVG_ORANGE, "0.01");
}

static void draw_ball(void)
{
    const struct svg_plot plot = {440.0,           50.0, 270.0, 270.0, {1e-5, 0.1},
                                  {10.0, 10000.0}, true, true};
    svg_plot_frame(&plot, 0.0, 0.0, "width of the gap, scene units",
                   "steps past a ball of radius 1");
    double law[2][2] = {{1e-5, 0.0}, {0.1, 0.0}};
    for (int i = 0; i < 2; i++)
        law[i][1] = 3.14159265358979323846 * sqrt(2.0 / law[i][0]);
    svg_plot_curve(&plot, 2, (const double(*)[2])law,
                   (struct svg_pen){.stroke = SVG_PALE, .width = 2.0});
    for (double delta = 0.1; delta > 0.9e-5; delta /= sqrt(10.0))
        svg_circle(svg_plot_x(&plot, delta), svg_plot_y(&plot, ball_moves(delta)), 4.5,
                   (struct svg_pen){.fill = SVG_BLUE});
    svg_text(540.0, 110.0, 'l', 14.0, SVG_INK, "&#960; &#8730;(2 / gap)");
    svg_text(476.0, 250.0, 'l', 14.0, SVG_BLUE, "counted");
}

int main(void)
{
    svg_begin(
        760.0, 380.0, "Why grazing rays are expensive",
        "Two plots with logarithmic axes. Left: the number of steps to a plane grows without limit "
        "as the angle decreases, from 2 or 3 near a right angle to about 100 at 4 degrees and "
        "thousands at a tenth of a degree. Right: the counted steps past a ball lie on the line pi "
        "times the square root of 2 over the gap: a gap a hundred times smaller takes ten times as "
        "many steps.");
    draw_plane();
    draw_ball();
    svg_end();
    return 0;
}
