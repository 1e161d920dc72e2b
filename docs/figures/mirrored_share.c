// mirrored_share.c - the share of light that a surface of glass mirrors, against the angle, from
// both sides.
#include "../../tests/support_glass.h"
#include "svg.h"

enum { POINTS = 361 };

static void curve(const struct svg_plot *plot, double index, int which, struct svg_pen pen)
{
    double point[POINTS][2], straight = pow((index - 1.0) / (index + 1.0), 2.0);
    for (int i = 0; i < POINTS; i++) {
        double angle = 90.0 * i / (POINTS - 1.0), c = cos(angle * MIRROR_PI / 180.0);
        point[i][0] = angle;
        point[i][1] = which == 0
                          ? glass_fresnel(c, 1.0 / index)
                          : (which == 1 ? glass_schlick(c, straight) : glass_fresnel(c, index));
    }
    svg_plot_curve(plot, POINTS, (const double(*)[2])point, pen);
}

int main(void)
{
    const struct svg_plot left = {70.0, 40.0, 290.0, 210.0, {0.0, 90.0}, {0.0, 1.0}, false, false};
    const struct svg_plot right = {440.0,       40.0,       290.0, 210.0,
                                   {0.0, 90.0}, {0.0, 1.0}, false, false};
    svg_begin(
        760.0, 330.0, "The mirrored share",
        "Two plots against the angle to the normal. From outside the share stays near 0.04 up to "
        "50 degrees and rises to 1 at 90; Schlick's curve runs a little below, then a little "
        "above. "
        "From inside it rises to 1 at the critical angle, 41 degrees for crown glass and 35 for "
        "flint, and stays there.");
    svg_plot_frame(&left, 15.0, 0.2, "degrees, from outside", "share");
    svg_plot_frame(&right, 15.0, 0.2, "degrees, from inside", "share");
    curve(&left, 1.5168, 0, (struct svg_pen){.stroke = SVG_BLUE, .width = 2.4});
    curve(&left, 1.5168, 1, (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.2, .dash = "6 4"});
    curve(&right, 1.5168, 2, (struct svg_pen){.stroke = SVG_BLUE, .width = 2.4});
    curve(&right, 1.7283, 2, (struct svg_pen){.stroke = SVG_TEAL, .width = 2.4, .dash = "8 4"});
    svg_text(70.0, 318.0, 'l', 14.0, SVG_BLUE, "solid: crown glass, 1.517");
    svg_text(260.0, 318.0, 'l', 14.0, SVG_ORANGE, "dashed: Schlick");
    svg_text(440.0, 318.0, 'l', 14.0, SVG_TEAL, "dashed: flint, 1.728");
    svg_end();
    return 0;
}
