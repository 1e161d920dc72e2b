// blend_shares.c - two blends of two distances, and three formulas for the share of the second
// distance: that of the cubic blend, that of the quadratic blend and the workshop's weight. All are
// plotted against the difference of the distances.
#include <math.h>
#include <stdio.h>

#include "svg.h"

enum { POINTS = 241 };

static const double k = 1.0; // width of the blend

static double cubic(double a, double b)
{
    double h = fmax(k - fabs(a - b), 0.0);
    return fmin(a, b) - h * h * h / (6.0 * k * k);
}

static double quadratic(double a, double b)
{
    double h = fmax(k - fabs(a - b), 0.0);
    return fmin(a, b) - h * h / (4.0 * k);
}

// The following are functions of x = a - b, with a = x / 2 and b = -x / 2.
static double cubic_share(double x)
{
    double h = fmax(k - fabs(x), 0.0), lesser = h * h / (2.0 * k * k);
    return x < 0.0 ? lesser : 1.0 - lesser;
}

static double quadratic_share(double x)
{
    return fmin(fmax(0.5 + x / (2.0 * k), 0.0), 1.0);
}

static double workshop_weight(double x)
{
    return fmin(fmax(x / 2.0 - cubic(x / 2.0, -x / 2.0), 0.0), 1.0);
}

static double least(double x)
{
    return -fabs(x) / 2.0;
}

static double cubic_value(double x)
{
    return cubic(x / 2.0, -x / 2.0);
}

static double quadratic_value(double x)
{
    return quadratic(x / 2.0, -x / 2.0);
}

static void curve(const struct svg_plot *plot, double (*f)(double), struct svg_pen pen)
{
    double point[POINTS][2];
    for (int i = 0; i < POINTS; i++) {
        point[i][0] = -1.5 + 3.0 * i / (POINTS - 1);
        point[i][1] = f(point[i][0]);
    }
    svg_plot_curve(plot, POINTS, (const double(*)[2])point, pen);
}

int main(void)
{
    const struct svg_plot depth = {70.0,        40.0,        290.0, 210.0,
                                   {-1.5, 1.5}, {-0.8, 0.0}, false, false};
    const struct svg_plot share = {440.0,       40.0,       290.0, 210.0,
                                   {-1.5, 1.5}, {0.0, 1.0}, false, false};
    const struct svg_pen blue = {.stroke = SVG_BLUE, .width = 2.4};
    const struct svg_pen teal = {.stroke = SVG_TEAL, .width = 2.4, .dash = "8 4"};
    const struct svg_pen orange = {.stroke = SVG_ORANGE, .width = 2.4, .dash = "2 4"};
    const struct svg_pen ink = {.stroke = SVG_INK, .width = 1.2};
    svg_begin(760.0, 330.0, "Two blends and their shares",
              "Left: the union of two distances against their difference. The minimum has a "
              "corner. Where the distances are equal, the cubic blend is lower by a sixth of its "
              "width, and the quadratic blend by a quarter. Right: the share of the second "
              "distance. In both blends, the share is one half where the distances are equal. The "
              "workshop's weight is a sixth there, and it is not symmetric.");
    svg_plot_frame(&depth, 0.5, 0.2, "a - b, in widths k", "the union");
    svg_plot_frame(&share, 0.5, 0.25, "a - b, in widths k", "share of b");
    curve(&depth, least, ink);
    curve(&depth, cubic_value, blue);
    curve(&depth, quadratic_value, teal);
    curve(&share, cubic_share, blue);
    curve(&share, quadratic_share, teal);
    curve(&share, workshop_weight, orange);
    svg_text(70.0, 318.0, 'l', 14.0, SVG_INK, "thin: min(a, b)");
    svg_text(200.0, 318.0, 'l', 14.0, SVG_BLUE, "solid: cubic");
    svg_text(320.0, 318.0, 'l', 14.0, SVG_TEAL, "dashed: quadratic");
    svg_text(480.0, 318.0, 'l', 14.0, SVG_ORANGE, "dotted: the workshop's weight, k = 1");
    svg_end();
    return 0;
}
