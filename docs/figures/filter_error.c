// filter_error.c - how far the mean of a pixel's samples is from the mean of 256 samples: for
// regular positions, for jittered positions, and for the workshop's grid.
#include <stddef.h>

#include "lib/filter.h"
#include "svg.h"

enum { SIDES = 8, CURVES = 5 };

int main(void)
{
    static const enum filter_way ways[CURVES] = {FILTER_BOX, FILTER_BOX_JITTERED,
                                                 FILTER_TENT_JITTERED, FILTER_GAUSSIAN_JITTERED,
                                                 FILTER_WORKSHOP};
    static const char *const colours[CURVES] = {SVG_BLUE, SVG_TEAL, SVG_INK, SVG_PALE, SVG_ORANGE};
    static const char *const words[CURVES] = {"box, regular", "box, jittered", "tent, jittered",
                                              "Gaussian, jittered", "the workshop's grid"};
    const struct svg_plot plot = {80.0, 40.0, 640.0, 340.0, {1.0, 100.0}, {1e-3, 1.0}, true, true};
    svg_begin(
        760.0, 440.0, "The error of a pixel against the number of its samples",
        "The root mean square difference from the mean of 256 samples, for a picture of a fan of "
        "fine rays. Both axes are logarithmic. Four lines fall: the line of the regular box is "
        "lowest, and the lines of the wider filters are higher. The workshop's grid stays between "
        "0.06 and 0.11, and its error rises from 4 samples on.");
    svg_plot_frame(&plot, 0.0, 0.0, "samples per pixel", "error, where white is 1");
    for (int curve = 0; curve < CURVES; curve++) {
        double point[SIDES][2];
        for (int i = 0; i < SIDES; i++) {
            point[i][0] = (i + 1) * (i + 1);
            point[i][1] = filter_error(ways[curve], i + 1);
        }
        svg_plot_curve(&plot, SIDES, (const double(*)[2])point,
                       (struct svg_pen){.stroke = colours[curve], .width = 2.4});
        for (int i = 0; i < SIDES; i++)
            svg_circle(svg_plot_x(&plot, point[i][0]), svg_plot_y(&plot, point[i][1]), 3.5,
                       (struct svg_pen){.fill = colours[curve]});
        svg_textf(104.0, 286.0 + 20.0 * curve, 'l', 15.0, colours[curve], "%s", words[curve]);
    }
    svg_end();
    return 0;
}
