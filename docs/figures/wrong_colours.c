// wrong_colours.c - two of the report's formulas about colour, as printed and corrected: a surface
// in light of different brightness, and the sky with the sun at different heights.
#include <math.h>
#include <stdio.h>

#include "svg.h"

static double held(double v)
{
    return fmin(fmax(v, 0.0), 1.0);
}

// ---- 1.5.5: a surface (1, 0.5, 0) under a white light of 0.15 to 0.9 ----

static void surface(double top)
{
    struct svg_plot plot[2];
    const double object[3] = {1.0, 0.5, 0.0};
    const char *const words[4] = {
        "report: min(object, light)", "Orange turns yellow where the light is below 0.5.",
        "correct: object &#215; light", "Orange stays orange, and darkens."};
    svg_pair(top, "1.5.5 &#160; A surface (1, 0.5, 0) under a white light of 0.15 to 0.9", words,
             (double[]){0.0, 6.0}, (double[]){0.0, 1.0}, plot);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 6; k++) {
            double light = 0.15 * (k + 1), x = plot[i].left + 14.0 + 52.5 * k,
                   y = plot[i].top + 20.0;
            double shown[3];
            char fill[8];
            for (int c = 0; c < 3; c++)
                shown[c] = i == 0 ? fmin(object[c], light) : object[c] * light;
            snprintf(fill, sizeof fill, "#%02x%02x%02x",
                     (unsigned)(255.0 * held(shown[0]) + 0.5) & 255u,
                     (unsigned)(255.0 * held(shown[1]) + 0.5) & 255u,
                     (unsigned)(255.0 * held(shown[2]) + 0.5) & 255u);
            svg_polygon(
                4, (const double[4][2]){{x, y}, {x + 49.0, y}, {x + 49.0, y + 70.0}, {x, y + 70.0}},
                (struct svg_pen){.fill = fill});
            svg_textf(x + 24.5, y + 92.0, 'm', 13.0, SVG_INK, "%.2f", light);
        }
}

// ---- 3.4: the blue of the day (0.5, 0.7, 1), against the height of the sun ----

static const double day[3] = {0.5, 0.7, 1.0};

static double sky_wrong(int channel, double sine)
{
    return channel == 0 ? day[0] : day[channel] * -sine;
}

// The air mass and the optical depths of shaders/sky.glsl.
static double sky_right(int channel, double sine)
{
    const double depth[3] = {0.04, 0.1, 0.25}, earth = 721.5, horizon = 2.0 * earth + 1.0;
    double s = earth * sine, mass = horizon / (sqrt(s * s + horizon) + s);
    return day[channel] * exp(-depth[channel] * (mass - 1.0));
}

static void draw_axes(const struct svg_plot *plot, double below)
{
    double base = svg_plot_y(plot, 0.0);
    svg_line(svg_plot_x(plot, 0.0), base, svg_plot_x(plot, 92.0), base,
             (struct svg_pen){.stroke = SVG_INK, .width = 1.0});
    for (int tick = -1; tick <= 1; tick++)
        svg_textf(svg_plot_x(plot, -2.5), svg_plot_y(plot, tick) + 4.0, 'r', 13.0, SVG_INK, "%s%d",
                  tick < 0 ? "&#8722;" : "", tick < 0 ? -tick : tick);
    for (int tick = 30; tick <= 90; tick += 30)
        svg_textf(svg_plot_x(plot, tick), base + below, 'm', 13.0, SVG_INK, "%d&#176;", tick);
}

static void draw_channels(const struct svg_plot *plot, double (*channel)(int, double),
                          const double *nudge)
{
    const double degree = atan(1.0) / 45.0;
    static const char *const colour[3] = {SVG_ORANGE, SVG_TEAL, SVG_BLUE};
    static const char *const name[3] = {"red", "green", "blue"};
    for (int c = 0; c < 3; c++) {
        double point[181][2];
        for (int k = 0; k <= 180; k++) {
            point[k][0] = 0.5 * k;
            point[k][1] = channel(c, sin(point[k][0] * degree));
        }
        svg_plot_curve(plot, 181, (const double(*)[2])point,
                       (struct svg_pen){.stroke = colour[c], .width = 2.2});
        svg_text(svg_plot_x(plot, 92.0), svg_plot_y(plot, point[180][1]) + 4.0 + nudge[c], 'l',
                 13.0, colour[c], name[c]);
    }
}

static void sky(double top)
{
    struct svg_plot plot[2];
    const char *const words[4] = {"report: green, blue times &#10216;up, ray direction&#10217;",
                                  "Negative all day long: the sky at noon is red.",
                                  "correct: each channel times exp(&#8722;&#964; (m &#8722; 1))",
                                  "Blue by day; red when the sun is low."};
    svg_pair(top, "3.4 &#160; The sky's red, green and blue, for a sun 0&#176; to 90&#176; high",
             words, (double[]){-14.0, 112.0}, (double[]){-1.25, 1.3}, plot);
    draw_axes(&plot[0], -5.0);
    draw_axes(&plot[1], 16.0);
    draw_channels(&plot[0], sky_wrong, (double[]){0.0, 0.0, 0.0});
    draw_channels(&plot[1], sky_right, (double[]){6.0, 0.0, -2.0}); // keep the names apart
}

int main(void)
{
    svg_begin(
        760.0, 2.0 * SVG_PAIR_ROW + 8.0, "Two formulas about colour, as printed and corrected",
        "Two rows, each with the report's formula on the left and the correct formula on the "
        "right. The first row shows an orange surface in six lights: with the minimum, it is "
        "yellow in the three dimmest; with the product, it is orange in all six. The second row "
        "shows the sky's red, green and blue against the height of the sun: with the report's "
        "product, green and blue are negative by day; with the transmittance of the air, blue is "
        "largest by day, and all but a little red is lost at the horizon.");
    surface(8.0);
    sky(8.0 + SVG_PAIR_ROW);
    svg_end();
    return 0;
}
