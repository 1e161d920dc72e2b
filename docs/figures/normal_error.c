// normal_error.c - the error of the normal against the step: two curves for the unit ball at z = 10
// in 32-bit floats, measured with the function that `build/tests/measure normal` uses.
#include <stddef.h>

#include "lib/measure.h"
#include "svg.h"

enum { STEPS = 57 };

int main(void)
{
    const struct svg_plot plot = {80.0, 50.0, 640.0, 330.0, {1e-7, 1.0}, {1e-4, 100.0}, true, true};
    double central[STEPS][2], forward[STEPS][2];
    for (int i = 0; i < STEPS; i++) {
        double h = pow(10.0, -7.0 + i / 8.0);
        struct normal_error error = measure_normal(h);
        central[i][0] = forward[i][0] = h;
        central[i][1] = error.central;
        forward[i][1] = error.forward;
    }
    svg_begin(760.0, 440.0, "The step of the normal: two U-shaped curves",
              "The worst angle between the computed and the true normal is plotted against the "
              "step; both axes are logarithmic. On the left, where rounding dominates, both curves "
              "fall like one over the step. The error of forward differences is smallest, about "
              "0.05 degrees, near a step of 0.0004 and then rises in proportion to the step. The "
              "error of central differences is smallest, about 0.0014 degrees, near a step of "
              "0.008 and then rises with the square of the step.");
    svg_plot_frame(&plot, 0.0, 0.0, "step, scene units", "worst angle, degrees");
    svg_plot_curve(
        &plot, STEPS, (const double(*)[2])forward,
        (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.4, .dash = "8 4", .decimals = 1});
    svg_plot_curve(&plot, STEPS, (const double(*)[2])central,
                   (struct svg_pen){.stroke = SVG_BLUE, .width = 2.6, .decimals = 1});
    svg_text(520.0, 128.0, 'r', 15.0, SVG_ORANGE, "forward");
    svg_text(632.0, 262.0, 'l', 15.0, SVG_BLUE, "central");
    svg_text(150.0, 200.0, 'l', 14.0, SVG_INK, "rounding: 1 / step");
    svg_end();
    return 0;
}
