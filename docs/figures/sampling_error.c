// sampling_error.c - the error of the visible share of a disc-shaped light against the number of
// rays. Either all rays are random over the whole disc, or each cell of the disc has one random
// ray. An edge cuts the disc; for comparison, a third curve is for a light that varies smoothly.
#include <math.h>
#include <stddef.h>

#include "lib/random.h"
#include "svg.h"

enum { SIDES = 8, TRIES = 4096, CURVES = 3 };

static const int sides[SIDES] = {1, 2, 3, 4, 6, 8, 12, 16};
static const double pi = 3.14159265358979323846;

// One estimate: the mean over side x side rays.
//   curve  0: random rays past an edge; 1: one ray per cell past an edge; 2: one ray per cell to a
//          smooth light of brightness 1 + x / 2
//   clear  the edge: the part of the disc with x < clear is visible
static double estimate(int curve, int side, int attempt, double clear)
{
    double sum = 0.0;
    for (int i = 0; i < side * side; i++) {
        double u = random_of(attempt, 7, 0, 2 * i), v = random_of(attempt, 7, 0, 2 * i + 1);
        if (curve > 0) {
            u = (i % side + u) / side;
            v = (i / side + v) / side;
        }
        double x = sqrt(u) * cos(2.0 * pi * v);
        sum += curve == 2 ? 1.0 + 0.5 * x : (x < clear ? 1.0 : 0.0);
    }
    return sum / (side * side);
}

// The root mean square error over many points of the penumbra.
static double error_of(int curve, int side)
{
    double squares = 0.0;
    for (int attempt = 0; attempt < TRIES; attempt++) {
        double clear = -0.95 + 1.9 * (attempt + 0.5) / TRIES;
        double edge = 0.5 + (asin(clear) + clear * sqrt(1.0 - clear * clear)) / pi;
        double off = estimate(curve, side, attempt, clear) - (curve == 2 ? 1.0 : edge);
        squares += off * off;
    }
    return sqrt(squares / TRIES);
}

// The slope of the least-squares line through the logarithms of the points with at least 4 rays.
static double slope_of(const double (*point)[2])
{
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (int i = 1; i < SIDES; i++) {
        double a = log(point[i][0]), b = log(point[i][1]);
        n += 1.0;
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

int main(void)
{
    static const char *const colours[CURVES] = {SVG_ORANGE, SVG_BLUE, SVG_TEAL};
    static const char *const words[CURVES] = {"random rays, an edge", "one ray per cell, an edge",
                                              "one ray per cell, smooth light"};
    const struct svg_plot plot = {80.0, 40.0, 640.0, 340.0, {1.0, 300.0}, {1e-3, 1.0}, true, true};
    svg_begin(
        760.0, 440.0, "The error against the number of rays",
        "The root mean square error of the visible share is plotted against the number of rays; "
        "both axes are logarithmic. The slope is -0.51 with random rays, -0.76 with one ray per "
        "cell and an edge across the disc, and -1.00 with one ray per cell and a light without an "
        "edge.");
    svg_plot_frame(&plot, 0.0, 0.0, "rays", "error of the share");
    for (int curve = 0; curve < CURVES; curve++) {
        double point[SIDES][2];
        for (int i = 0; i < SIDES; i++) {
            point[i][0] = sides[i] * sides[i];
            point[i][1] = error_of(curve, sides[i]);
        }
        svg_plot_curve(&plot, SIDES, (const double(*)[2])point,
                       (struct svg_pen){.stroke = colours[curve], .width = 2.4});
        for (int i = 0; i < SIDES; i++)
            svg_circle(svg_plot_x(&plot, point[i][0]), svg_plot_y(&plot, point[i][1]), 3.5,
                       (struct svg_pen){.fill = colours[curve]});
        svg_textf(104.0, 300.0 + 24.0 * curve, 'l', 15.0, colours[curve], "%s: slope %.2f",
                  words[curve], slope_of((const double(*)[2])point));
    }
    svg_end();
    return 0;
}
