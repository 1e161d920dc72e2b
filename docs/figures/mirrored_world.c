// mirrored_world.c - a ray goes on through the water into the mirrored world: which point of the
// land its march asks, where the water is level and where a wave tilts it.
#include <math.h>
#include <stddef.h>

#include "svg.h"

#define LAND 9

static const double level = 190.0; // of the water on the page

int main(void)
{
    const double eye[2] = {50.0, 130.0}, water[2] = {270.0, level}, way = 240.6, tilt = 0.05;
    const double land[LAND][2] = {{400.0, 0.0},   {450.0, 32.0},  {500.0, 60.0},
                                  {545.0, 128.0}, {580.0, 118.0}, {622.0, 170.0},
                                  {660.0, 128.0}, {705.0, 62.0},  {740.0, 0.0}};
    double above[LAND][2], below[LAND][2], end[3][2];
    for (int i = 0; i < LAND; i++) {
        above[i][0] = below[i][0] = land[i][0];
        above[i][1] = level - land[i][1];
        below[i][1] = level + land[i][1];
    }
    // A facet that is tilted by an angle turns what it mirrors by twice as much.
    double falls = atan2(water[1] - eye[1], water[0] - eye[0]),
           angles[3] = {falls, -falls, -falls - 2.0 * tilt};
    for (int i = 0; i < 3; i++) {
        end[i][0] = water[0] + way * cos(angles[i]);
        end[i][1] = water[1] + way * sin(angles[i]);
    }
    svg_begin(760.0, 390.0, "The mirrored world",
              "A mountain stands over a line of water, and upside down below it. From the eye at "
              "the left a ray falls on the water and goes straight on to a point p below. Two "
              "arrows of the same length rise from the water: one to the point above p, and a "
              "steeper one where the water is tilted, which ends in the air.");
    svg_polygon(LAND, (const double(*)[2])above,
                (struct svg_pen){.fill = SVG_SAND, .stroke = SVG_ORANGE});
    svg_polygon(
        LAND, (const double(*)[2])below,
        (struct svg_pen){.fill = SVG_SAND, .stroke = SVG_ORANGE, .dash = "5 4", .opacity = 0.5});
    svg_line(20.0, level, 740.0, level, (struct svg_pen){.stroke = SVG_BLUE, .width = 2.5});
    svg_line(end[0][0], end[0][1], end[1][0], end[1][1],
             (struct svg_pen){.stroke = SVG_PALE, .dash = "4 4"});
    svg_line(eye[0], eye[1], water[0], water[1], (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    svg_arrow(water[0], water[1], end[0][0], end[0][1],
              (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    svg_arrow(water[0], water[1], end[1][0], end[1][1],
              (struct svg_pen){.stroke = SVG_TEAL, .width = 2.0});
    svg_arrow(water[0], water[1], end[2][0], end[2][1],
              (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0});
    svg_line(water[0] - 46.0 * cos(tilt), water[1] + 46.0 * sin(tilt), water[0] + 46.0 * cos(tilt),
             water[1] - 46.0 * sin(tilt), (struct svg_pen){.stroke = SVG_BLUE, .width = 5.0});
    svg_circle(eye[0], eye[1], 5.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(eye[0], eye[1] - 14.0, 'm', 15.0, SVG_INK, "eye");
    svg_text(40.0, level + 22.0, 'l', 15.0, SVG_BLUE, "water");
    svg_text(end[0][0] + 10.0, end[0][1] + 10.0, 'l', 15.0, SVG_INK,
             "<tspan font-style='italic'>p</tspan>");
    svg_text(end[1][0] + 10.0, end[1][1] + 5.0, 'l', 15.0, SVG_TEAL, "where the water is level");
    svg_text(end[2][0] - 10.0, end[2][1] - 8.0, 'r', 15.0, SVG_BLUE, "where a wave tilts it");
    svg_end();
    return 0;
}
