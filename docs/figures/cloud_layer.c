// cloud_layer.c - how far the clouds are in a direction: of a flat layer, and of one over the
// round Earth.
#include <math.h>

#include "svg.h"

enum { POINTS = 240 };

static const double earth = 6371.0, altitude = 1.2, pi = 3.14159265358979323846;

static double distance(int curve, double degrees)
{
    double y = sin(degrees * pi / 180.0), b = earth * y;
    double c = altitude * (2.0 * earth + altitude);
    return curve == 0 ? altitude / y : c / (b + sqrt(b * b + c));
}

int main(void)
{
    static const char *const colours[2] = {SVG_ORANGE, SVG_BLUE};
    static const char *const words[2] = {"flat layer", "layer over a round Earth"};
    static const double place[2][2] = {{0.6, 300.0}, {2.6, 34.0}};
    const struct svg_plot plot = {80.0,        40.0,          640.0, 340.0,
                                  {0.0, 15.0}, {1.0, 1000.0}, false, true};
    svg_begin(760.0, 440.0, "How far the clouds are in a direction",
              "The distance of the clouds against the height over the horizon, for a layer 1.2 "
              "kilometres up. A flat layer runs off to infinity at the horizon. Over a round Earth "
              "it is 124 kilometres away there. Above 5 degrees both are nearly the same.");
    svg_plot_frame(&plot, 2.5, 0.0, "degrees over the horizon", "kilometres");
    for (int curve = 0; curve < 2; curve++) {
        double point[POINTS][2];
        for (int i = 0; i < POINTS; i++) {
            double degrees = 15.0 * (i + (curve == 0 ? 0.6 : 0.0)) / (POINTS - 1);
            point[i][0] = fmin(degrees, 15.0);
            point[i][1] = distance(curve, fmax(point[i][0], 1e-6));
        }
        svg_plot_curve(&plot, POINTS, (const double(*)[2])point,
                       (struct svg_pen){.stroke = colours[curve], .width = 2.4});
        svg_text(svg_plot_x(&plot, place[curve][0]), svg_plot_y(&plot, place[curve][1]), 'l', 15.0,
                 colours[curve], words[curve]);
    }
    svg_end();
}
