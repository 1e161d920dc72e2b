// land_bounds.c - how high the land of chapter 21 can stand ahead of a place on the mountain, by
// the hills alone and by one, two and four octaves of ridges; and how high it stands.
#include <math.h>
#include <stddef.h>

#include "../../tests/support_noise.h"
#include "svg.h"

#define POINTS 121

static const double cells = 0.08, gain = 0.42, lacunarity = 2.1, foot = 0.4, ridges = 3.6,
                    slope = 0.45;
static const double place[2] = {-1.979, 36.029}; // right and ahead: under pixel 300,240, step 1

// The hill in the middle, `ahead` of the place.
static double hills(double ahead)
{
    double x = (place[0] - 4.0) / 43.0, y = (place[1] + ahead - 46.0) / 25.5,
           w = fmax(1.0 - x * x - y * y, 0.0);
    return 7.4 * w * w - 3.0;
}

static double roughness(double base)
{
    return ridges * fmax(base - foot, 0.0);
}

// D by the first `count` of four octaves, the others counted as 1; and the bound of its slope.
static double ridged(double ahead, int count, double *stretch)
{
    double x = cells * place[0] + 31.2, y = cells * (place[1] + ahead) + 9.9;
    double weight = 1.0 - gain, sum = 0.0, rest = 1.0, first = 1.0, scale = 1.0,
           slopes = 1.0 + weight;
    for (int i = 0; i < count; i++) {
        double ridge = 1.0 - fabs(2.0 * noise_value((struct d3){x, 0.0, y}).value - 1.0);
        double turned = lacunarity * (0.8 * x - 0.6 * y) + 17.17;
        y = lacunarity * (0.6 * x + 0.8 * y) + 29.73;
        x = turned;
        first = i == 0 ? ridge : first;
        sum += weight * ridge;
        rest -= weight;
        slopes += i > 0 ? weight * scale : 0.0;
        weight *= gain;
        scale *= lacunarity;
    }
    *stretch = 2.0 * 1.875 * cells * slopes;
    return first * (sum + (count < 4 ? rest : 0.0));
}

// The highest that the land can stand `ahead`: no octave asked, or so many.
static double highest(double ahead, int count)
{
    double base = hills(0.0), stretch, d = ridged(0.0, count, &stretch);
    double steep = slope + slope * ridges * d + roughness(base) * stretch;
    double climbed = base + slope * ahead;
    return count > 0 ? base + roughness(base) * d + steep * ahead +
                           slope * ridges * stretch * ahead * ahead
                     : climbed + roughness(climbed);
}

// Where the bound reaches a height that it starts below.
static double reaches(double height, int count)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        bool below = highest(middle, count) < height;
        low = below ? middle : low;
        high = below ? high : middle;
    }
    return low;
}

int main(void)
{
    const struct svg_plot plot = {70.0, 30.0, 650.0, 330.0, {0.0, 0.5}, {6.0, 9.5}, false, false};
    const int counts[4] = {0, 1, 2, 4};
    const char *const colours[4] = {SVG_ORANGE, SVG_PALE, SVG_TEAL, SVG_BLUE};
    const char *const names[4] = {"the hills alone", "one octave", "two octaves", "four octaves"};
    const double rays[2] = {8.4, 8.82};
    svg_begin(
        760.0, 420.0, "How high the land can stand ahead",
        "Height over the way ahead. A straight line begins highest and rises least. A curve "
        "for one, two and four octaves each begins lower and rises faster, and all stay above "
        "the land. A low level ray meets the curve of four octaves last, a high one the line.");
    svg_plot_frame(&plot, 0.1, 0.5, "way ahead, scene units", "height, scene units");
    double land[POINTS + 2][2], curve[POINTS][2], stretch;
    for (int i = 0; i < POINTS; i++) {
        double ahead = 0.5 * i / (POINTS - 1), base = hills(ahead);
        land[i][0] = svg_plot_x(&plot, ahead);
        land[i][1] = svg_plot_y(&plot, base + roughness(base) * ridged(ahead, 4, &stretch));
    }
    land[POINTS][0] = svg_plot_x(&plot, 0.5);
    land[POINTS + 1][0] = svg_plot_x(&plot, 0.0);
    land[POINTS][1] = land[POINTS + 1][1] = svg_plot_y(&plot, 6.0);
    svg_polygon(POINTS + 2, (const double(*)[2])land, (struct svg_pen){.fill = SVG_SAND});
    for (int r = 0; r < 2; r++)
        svg_line(svg_plot_x(&plot, 0.0), svg_plot_y(&plot, rays[r]), svg_plot_x(&plot, 0.5),
                 svg_plot_y(&plot, rays[r]), (struct svg_pen){.stroke = SVG_INK, .dash = "6 4"});
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < POINTS; i++) {
            curve[i][0] = 0.5 * i / (POINTS - 1);
            curve[i][1] = highest(curve[i][0], counts[k]);
        }
        svg_plot_curve(&plot, POINTS, (const double(*)[2])curve,
                       (struct svg_pen){.stroke = colours[k], .width = 2.4});
        for (int r = 0; r < 2; r++)
            svg_circle(svg_plot_x(&plot, reaches(rays[r], counts[k])), svg_plot_y(&plot, rays[r]),
                       4.0, (struct svg_pen){.fill = colours[k]});
        double x = svg_plot_x(&plot, 0.37), y = svg_plot_y(&plot, 8.2 - 0.24 * k);
        svg_line(x, y, x + 30.0, y, (struct svg_pen){.stroke = colours[k], .width = 2.4});
        svg_text(x + 38.0, y + 5.0, 'l', 15.0, SVG_INK, names[k]);
    }
    svg_text(svg_plot_x(&plot, 0.49), svg_plot_y(&plot, 8.55), 'r', 15.0, SVG_INK,
             "two level rays");
    svg_text(svg_plot_x(&plot, 0.44), svg_plot_y(&plot, 6.6), 'm', 15.0, SVG_INK, "the land");
    svg_end();
    return 0;
}
