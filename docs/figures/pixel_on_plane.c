// pixel_on_plane.c - what six pixels of one picture see of a chequered plane, from above: each a
// four-sided figure, and the smallest rectangle along the pattern's axes that holds it.
#include <math.h>
#include <stdio.h>

#include "svg.h"

static const double eye_height = 1.4, focal = 2.0, tilt = 0.24; // radians, downwards
static const double unit = 92.0, left = 380.0,
                    bottom = 400.0; // pixels a side of a square; of the page

// The place of the plane that a place of the screen shows: x to the right, z away.
static void place_of(double x, double y, double place[2])
{
    double up = y * cos(tilt) - focal * sin(tilt), ahead = focal * cos(tilt) + y * sin(tilt);
    double t = -eye_height / up;
    place[0] = left + unit * t * x;
    place[1] = bottom - unit * (t * ahead - 2.3);
}

static void draw_pixel(double x, double y)
{
    const double half = 1.0 / 14.0; // a coarse picture, 14 pixels high, so that one sees them
    double corner[4][2], low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    for (int i = 0; i < 4; i++) {
        place_of(x + (i == 1 || i == 2 ? half : -half), y + (i < 2 ? -half : half), corner[i]);
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], corner[i][k]);
            high[k] = fmax(high[k], corner[i][k]);
        }
    }
    const double box[4][2] = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    svg_polygon(
        4, box,
        (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0, .fill = SVG_SAND, .opacity = 0.85});
    svg_polygon(
        4, (const double(*)[2])corner,
        (struct svg_pen){.stroke = SVG_BLUE, .width = 2.2, .fill = SVG_SKY, .opacity = 0.9});
}

int main(void)
{
    svg_begin(760.0, 470.0, "What a pixel sees of a plane",
              "A chequered plane from above. Six pixels are drawn as blue four-sided figures: near "
              "ones are small and "
              "nearly square, far ones are long, and those at the sides are sheared. Around each "
              "stands the smallest "
              "rectangle along the pattern's axes, in orange; in the middle of the picture it "
              "fits, at the sides it is "
              "larger.");
    for (int i = -4; i <= 4; i++)
        for (int k = 0; k < 5; k++)
            if ((i + k) % 2 == 0) {
                double x0 = left + unit * (i - 0.5), y0 = bottom - unit * k;
                const double square[4][2] = {
                    {x0, y0}, {x0 + unit, y0}, {x0 + unit, y0 - unit}, {x0, y0 - unit}};
                svg_polygon(4, square, (struct svg_pen){.fill = "#e4e2dd"});
            }
    static const double pixels[6][2] = {{0.0, -0.5},  {1.15, -0.5},  {-0.9, -0.3},
                                        {0.0, -0.22}, {0.75, -0.18}, {-0.6, -0.06}};
    for (int i = 0; i < 6; i++)
        draw_pixel(pixels[i][0], pixels[i][1]);
    svg_text(30.0, 440.0, 'l', 15.0, SVG_BLUE, "blue: what the pixel sees");
    svg_text(290.0, 440.0, 'l', 15.0, SVG_ORANGE, "orange: the rectangle that is averaged");
    svg_end();
    return 0;
}
