// star_cells.c - a hemisphere of stars, drawn as a disc of rings with equal widths. The rings are
// divided into cells of equal solid angle, with one star in each cell. Beside the disc is a plot of
// the number of cubes of a grid that a sphere meets.
#include <math.h>
#include <stdint.h>

#include "svg.h"

#define TURN 6.283185307179586

enum { RINGS = 5, SIZE = 150 };

static const double middle[2] = {185.0, 190.0};

// A random number in [0, 1) for a cell.
static double lot(int ring, int column, uint32_t seed)
{
    uint32_t v = (uint32_t)(ring * 97 + column) * 2654435761U + seed * 40503U;
    v = (v ^ (v >> 16)) * 2146121005U;
    v = (v ^ (v >> 15)) * 2221713035U;
    return (v ^ (v >> 16)) / 4294967296.0;
}

static void cells(void)
{
    const struct svg_pen line = {.stroke = SVG_PALE, .width = 1.0};
    svg_circle(middle[0], middle[1], SIZE, (struct svg_pen){.fill = SVG_SKY, .stroke = SVG_INK});
    for (int ring = 0; ring < RINGS; ring++) {
        int count = 8 * ring + 4;
        double inner = (double)SIZE * ring / RINGS, outer = (double)SIZE * (ring + 1) / RINGS;
        svg_circle(middle[0], middle[1], outer, line);
        for (int k = 0; k < count; k++) {
            double c = cos(TURN * k / count), s = sin(TURN * k / count);
            svg_line(middle[0] + inner * c, middle[1] - inner * s, middle[0] + outer * c,
                     middle[1] - outer * s, line);
            double at = sqrt(ring * ring + lot(ring, k, 1) * (2.0 * ring + 1.0)) / RINGS * SIZE;
            double turn = TURN * (k + lot(ring, k, 2)) / count;
            svg_circle(middle[0] + at * cos(turn), middle[1] - at * sin(turn), 2.4,
                       (struct svg_pen){.fill = SVG_INK});
        }
    }
    svg_text(middle[0], 366.0, 'm', 14.0, SVG_INK, "one star in each cell of equal solid angle");
}

// Plot the number of cubes per unit area of the sphere along a great circle, which leads from an
// axis of the grid through the cube's space diagonal to a face diagonal.
static void cubes(void)
{
    struct svg_plot plot = {.left = 440.0,
                            .top = 50.0,
                            .width = 290.0,
                            .height = 255.0,
                            .x = {0.0, 90.0},
                            .y = {0.0, 2.0}};
    svg_plot_frame(&plot, 30.0, 0.5, "degrees from an axis of the grid", "");
    double grid[181][2], even[2][2] = {{0.0, 1.0}, {90.0, 1.0}};
    for (int i = 0; i <= 180; i++) {
        double a = TURN / 720.0 * i, c = cos(a), s = sin(a) / sqrt(2.0);
        grid[i][0] = 0.5 * i;
        grid[i][1] = c + 2.0 * s;
    }
    svg_plot_curve(&plot, 181, (const double(*)[2])grid,
                   (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.5});
    svg_plot_curve(&plot, 2, (const double(*)[2])even,
                   (struct svg_pen){.stroke = SVG_BLUE, .width = 2.5});
    svg_text(svg_plot_x(&plot, 54.7), svg_plot_y(&plot, 1.78), 'm', 14.0, SVG_INK,
             "cubes that a sphere meets");
    svg_text(svg_plot_x(&plot, 54.7), svg_plot_y(&plot, 0.84), 'm', 14.0, SVG_INK,
             "cells of equal solid angle");
    svg_text(585.0, 36.0, 'm', 14.0, SVG_INK, "stars per unit area");
}

int main(void)
{
    svg_begin(
        760.0, 390.0, "Cells for stars",
        "Left: a disc of five rings, divided into cells of equal area with a dot in each. Right: "
        "the number of cubes that a sphere meets per unit area rises from 1 at an axis of the grid "
        "to 1.73 at the grid's diagonal and falls to 1.41 at 90 degrees, while the number of cells "
        "of equal solid angle stays at 1.");
    cells();
    cubes();
    svg_end();
    return 0;
}
