// plane_weights.c - the weights of three pictures, and the sum of the weights, as the normal turns
// from the x axis to the y axis. There are four methods: the workshop's weights, these weights
// divided by their sum, their sixth powers, and the weights minus the smallest weight. The sixth
// powers and the differences are also divided by their sums.
#include <math.h>
#include <stddef.h>

#include "svg.h"

enum { POINTS = 181, PLANES = 3 };

// Compute the three weights of a normal, one for each axis, with one of four methods.
//   row  the method, 0 to 3
static void weights_of(int row, const double normal[PLANES], double weight[PLANES])
{
    double sum = 0.0, least = 1.0;
    for (int i = 0; i < PLANES; i++) {
        weight[i] = pow(fabs(normal[i]), row == 2 ? 6.0 : 1.0);
        sum += weight[i];
        least = fmin(least, weight[i]);
    }
    for (int i = 0; row > 0 && i < PLANES; i++)
        weight[i] = row < 3 ? weight[i] / sum : (weight[i] - least) / (sum - 3.0 * least);
}

// Draw the plot of one method. The normal turns about the z axis from x to y, raised by 20 degrees
// towards z.
static void draw_row(int row, double left, double top, const char *name, const char *below)
{
    static const char *const colour[PLANES] = {SVG_BLUE, SVG_TEAL, SVG_PALE};
    const double lean = 20.0 * atan(1.0) / 45.0;
    const struct svg_plot plot = {left, top, 300.0, 120.0, {0.0, 90.0}, {0.0, 2.0}, false, false};
    double curve[PLANES + 1][POINTS][2];
    for (int k = 0; k < POINTS; k++) {
        double degrees = 90.0 * k / (POINTS - 1), angle = degrees * atan(1.0) / 45.0;
        const double normal[PLANES] = {cos(lean) * cos(angle), cos(lean) * sin(angle), sin(lean)};
        double weight[PLANES], sum = 0.0;
        weights_of(row, normal, weight);
        for (int i = 0; i < PLANES; i++) {
            curve[i][k][0] = degrees;
            curve[i][k][1] = weight[i];
            sum += weight[i];
        }
        curve[PLANES][k][0] = degrees;
        curve[PLANES][k][1] = sum;
    }
    svg_plot_frame(&plot, 30.0, 0.5, row > 1 ? "degrees from x to y" : "", "");
    for (int i = 0; i < PLANES; i++)
        svg_plot_curve(&plot, POINTS, (const double(*)[2])curve[i],
                       (struct svg_pen){.stroke = colour[i], .width = 2.2});
    svg_plot_curve(&plot, POINTS, (const double(*)[2])curve[PLANES],
                   (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.2, .dash = "7 4"});
    svg_text(left, top - 28.0, 'l', 15.0, SVG_INK, name);
    svg_text(left, top - 10.0, 'l', 13.0, row == 0 ? SVG_ORANGE : SVG_BLUE, below);
}

int main(void)
{
    svg_begin(
        760.0, 470.0, "Four ways to weight three pictures",
        "Four plots of the weights against the angle of the normal, which turns from the x axis to "
        "the y axis and leans 20 degrees towards z. With the components of the normal as weights, "
        "the sum rises to 1.67. Divided by their sum, the weights add up to 1. With the sixth "
        "power, one picture replaces the other within 30 degrees. With the smallest weight "
        "subtracted from all three, only two pictures are mixed.");
    draw_row(0, 60.0, 66.0, "the components of the normal (workshop)",
             "the sum is up to 1.73: too bright");
    draw_row(1, 430.0, 66.0, "divided by their sum",
             "the sum is 1; all three are mixed everywhere");
    draw_row(2, 60.0, 280.0, "the sixth power, divided", "one picture per face, with narrow seams");
    draw_row(3, 430.0, 280.0, "minus the smallest, divided", "two lookups; the third weight is 0");
    const char *const word[4] = {"projected along x", "along y", "along z", "their sum"};
    const char *const colour[4] = {SVG_BLUE, SVG_TEAL, SVG_PALE, SVG_ORANGE};
    for (int i = 0; i < 4; i++) {
        double x = 70.0 + 175.0 * i;
        svg_line(
            x, 452.0, x + 26.0, 452.0,
            (struct svg_pen){.stroke = colour[i], .width = 2.4, .dash = i == 3 ? "7 4" : NULL});
        svg_text(x + 34.0, 457.0, 'l', 14.0, SVG_INK, word[i]);
    }
    svg_end();
    return 0;
}
