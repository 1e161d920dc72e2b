// repetition.c - the report's figure 6: plots of the position in a cell, from the correct formula
// and from the report's formula, which never reaches the centre of a cell. Below the plots is a row
// of balls, because a ball in one cell appears in every cell.
#include <math.h>

#include "svg.h"

static const double period = 2.0;

static double right_position(double x)
{
    return x - period * floor(x / period + 0.5);
}

// The formula in section 2.2.3 of the report: mod(x - N/2, N) + N/2.
static double report_position(double x)
{
    double y = x - 0.5 * period;
    return y - period * floor(y / period) + 0.5 * period;
}

static void plot_position(double left, const char *name, double (*position)(double),
                          const char *colour)
{
    const struct svg_plot plot = {left, 60.0, 280.0, 150.0, {-4.0, 4.0}, {-2.0, 4.0}, false, false};
    svg_plot_frame(&plot, 2.0, 2.0, "<tspan font-style='italic'>x</tspan>", name);
    double band = svg_plot_y(&plot, 0.6), height = svg_plot_y(&plot, -0.6);
    const double corner[4][2] = {
        {left, band}, {left + 280.0, band}, {left + 280.0, height}, {left, height}};
    svg_polygon(4, corner, (struct svg_pen){.fill = SVG_SKY, .opacity = 0.8});
    for (int cell = -5; cell < 5; cell++) {
        double start = cell * 1.0, line[2][2] = {{start, 0.0}, {start + 1.0, 0.0}};
        line[0][1] = position(start + 1e-6);
        line[1][1] = position(start + 1.0 - 1e-6);
        svg_plot_curve(&plot, 2, (const double(*)[2])line,
                       (struct svg_pen){.stroke = colour, .width = 2.4});
    }
}

int main(void)
{
    svg_begin(
        760.0, 400.0, "Repetition of one coordinate",
        "Two sawtooth curves show the position in a cell of width 2 against x. The correct formula "
        "runs from minus 1 to 1 in each cell and crosses the band from minus 0.6 to 0.6, in which "
        "a ball of radius 0.6 lies. The report's formula runs from 1 to 3 and never meets that "
        "band. Below is a row of balls, one per cell; dashed lines are the walls of the cells.");
    plot_position(70.0, "correct: x &#8722; N &#8970;x/N + &#189;&#8971;", right_position,
                  SVG_BLUE);
    plot_position(440.0, "report: mod(x &#8722; N/2, N) + N/2", report_position, SVG_ORANGE);
    const double unit = 72.0, middle = 380.0, row = 320.0;
    for (int cell = -3; cell <= 2; cell++) {
        double x = middle + unit * period * cell;
        const struct svg_pen ball = {
            .stroke = SVG_BLUE, .width = 2.0, .fill = SVG_SKY, .opacity = cell == 0 ? 1.0 : 0.55};
        if (fabs(x - middle) < 360.0)
            svg_circle(x, row, unit * 0.6, ball);
        double wall = x + 0.5 * unit * period;
        svg_line(wall, row - 62.0, wall, row + 62.0,
                 (struct svg_pen){.stroke = SVG_INK, .width = 1.0, .dash = "5 4"});
        if (fabs(x - middle) < 360.0)
            svg_textf(x, row + 5.0, 'm', 15.0, SVG_BLUE, "cell %s%d", cell < 0 ? "&#8722;" : "",
                      cell < 0 ? -cell : cell);
    }
    svg_end();
    return 0;
}
