// hue_curves.c - the report's figure 5: red, green and blue over the hue, and the colours they
// make.
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "svg.h"

// The formula of shaders/hue.glsl; offset is 0, 4, 2 for red, green, blue.
static double channel(double hue, double offset)
{
    double place = fmod(hue / 60.0 + offset, 6.0);
    return fmax(0.0, fmin(1.0, fabs(place - 3.0) - 1.0));
}

static double encode(double v)
{
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

// All hues in a row, the numbers read as linear light and encoded for the screen, or written to the
// screen as they are.
static void draw_colours(double top, bool linear)
{
    const struct svg_plot plot = {70.0, top, 650.0, 30.0, {0.0, 360.0}, {0.0, 1.0}, false, false};
    const double offset[3] = {0.0, 4.0, 2.0};
    for (int i = 0; i < 180; i++) {
        double hue = 2.0 * i, x = svg_plot_x(&plot, hue), next = svg_plot_x(&plot, hue + 2.0);
        unsigned byte[3];
        for (int k = 0; k < 3; k++) {
            double v = channel(hue + 1.0, offset[k]);
            byte[k] = (unsigned)(255.0 * (linear ? encode(v) : v) + 0.5);
        }
        char colour[8];
        snprintf(colour, sizeof colour, "#%02x%02x%02x", byte[0], byte[1], byte[2]);
        const double corner[4][2] = {
            {x, top}, {next + 0.5, top}, {next + 0.5, top + 30.0}, {x, top + 30.0}};
        svg_polygon(4, corner, (struct svg_pen){.fill = colour});
    }
    svg_text(70.0, top - 7.0, 'l', 14.0, SVG_INK,
             linear ? "read as linear: light, as in our pictures"
                    : "read as encoded: numbers of a screen, as in a colour picker");
}

static void draw_channel(const char *name, double offset, double top, const char *colour, bool last)
{
    const struct svg_plot plot = {70.0, top, 650.0, 74.0, {0.0, 360.0}, {0.0, 1.0}, false, false};
    double curve[361][2], area[363][2];
    for (int i = 0; i <= 360; i++) {
        curve[i][0] = i;
        curve[i][1] = channel(i, offset);
        area[i][0] = svg_plot_x(&plot, i);
        area[i][1] = svg_plot_y(&plot, curve[i][1]);
    }
    area[361][0] = svg_plot_x(&plot, 360.0), area[361][1] = svg_plot_y(&plot, 0.0);
    area[362][0] = svg_plot_x(&plot, 0.0), area[362][1] = svg_plot_y(&plot, 0.0);
    svg_polygon(363, (const double(*)[2])area, (struct svg_pen){.fill = colour, .opacity = 0.25});
    svg_plot_frame(&plot, 60.0, 1.0, last ? "hue, degrees" : "", "");
    svg_plot_curve(&plot, 361, (const double(*)[2])curve,
                   (struct svg_pen){.stroke = colour, .width = 3.0});
    svg_text(22.0, top + 42.0, 'm', 16.0, colour, name);
}

int main(void)
{
    svg_begin(
        760.0, 520.0, "From a hue to red, green and blue",
        "Two strips of all hues over three curves. Red is full from 300 to 60 degrees, falls to "
        "nothing at 120 and rises again from 240. Green is the same curve 120 degrees later, full "
        "from 60 to 180; blue another 120 later, full from 180 to 300. The strips agree at the "
        "multiples of 60 degrees; between them the linear one is paler.");
    draw_colours(34.0, true);
    draw_colours(96.0, false);
    draw_channel("R", 0.0, 152.0, "#b3261e", false);
    draw_channel("G", 4.0, 262.0, "#1b7f3b", false);
    draw_channel("B", 2.0, 372.0, "#2446b8", true);
    svg_end();
    return 0;
}
