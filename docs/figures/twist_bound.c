// twist_bound.c - the factor by which a twist stretches distances: the largest singular value of
// its derivative.
#include <math.h>
#include <stddef.h>

#include "svg.h"

int main(void)
{
    const struct svg_plot plot = {70.0, 50.0, 650.0, 300.0, {0.0, 3.0}, {1.0, 3.5}, false, false};
    double right[121][2], wrong[121][2];
    for (int i = 0; i <= 120; i++) {
        double q = 3.0 * i / 120.0; // the plot's u: twist per unit times distance from the axis
        right[i][0] = wrong[i][0] = q;
        right[i][1] = 0.5 * (q + sqrt(q * q + 4.0));
        wrong[i][1] = sqrt(1.0 + q * q);
    }
    svg_begin(
        760.0, 410.0, "The Lipschitz bound of the twist",
        "Two curves against u, the twist per scene unit times the distance from the axis. The "
        "correct bound starts at 1 with a slope of one half, and is 1.618 at 1 and 3.303 at 3. The "
        "square root of 1 plus the square of u starts flat and stays below the bound: steps "
        "divided by that root are too long.");
    svg_plot_frame(&plot, 0.5, 0.5, "<tspan font-style='italic'>u = |&#956;| &#961;</tspan>",
                   "largest stretch");
    svg_plot_curve(&plot, 121, (const double(*)[2])wrong,
                   (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.4, .dash = "8 4"});
    svg_plot_curve(&plot, 121, (const double(*)[2])right,
                   (struct svg_pen){.stroke = SVG_BLUE, .width = 2.6});
    double x = svg_plot_x(&plot, 1.0), y = svg_plot_y(&plot, 0.5 * (1.0 + sqrt(5.0)));
    svg_circle(x, y, 5.0, (struct svg_pen){.fill = SVG_BLUE});
    svg_text(x - 8.0, y - 10.0, 'r', 15.0, SVG_BLUE, "1.618");
    svg_text(300.0, 130.0, 'l', 15.0, SVG_BLUE, "&#189; (u + &#8730;(u&#178; + 4))");
    svg_text(520.0, 262.0, 'l', 15.0, SVG_ORANGE, "&#8730;(1 + u&#178;), too small");
    svg_end();
    return 0;
}
