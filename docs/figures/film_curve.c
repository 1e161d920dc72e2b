// film_curve.c - what three curves make of a light, over its stops: clamped, the film's logistic
// curve with its toe and shoulder, and a smoothstep on the light.
#include <math.h>
#include <stddef.h>

#include "svg.h"

enum { POINTS = 241 };

static const double gamma_of_film = 1.45, white = 8.0;

static double film(double x)
{
    double g = pow(0.18, gamma_of_film), w = pow(white, gamma_of_film);
    double k = 0.82 * g * w / (0.18 * w - g), h = pow(fmin(x, white), gamma_of_film);
    return (1.0 + k / w) / (1.0 + k / h);
}

static double clamped(double x)
{
    return fmin(x, 1.0);
}

static double smooth(double x)
{
    double v = clamped(x);
    return v * v * (3.0 - 2.0 * v);
}

int main(void)
{
    static double (*const curves[])(double) = {clamped, smooth, film};
    static const char *const colours[] = {SVG_PALE, SVG_ORANGE, SVG_BLUE};
    static const char *const words[] = {"clamped", "smoothstep", "film: gamma 1.45, white 8"};
    const struct svg_plot plot = {80.0, 40.0, 640.0, 340.0, {-6.0, 6.0}, {0.0, 1.0}, false, false};
    svg_begin(
        760.0, 440.0, "Curves over stops",
        "The light that is shown against the light that arrives, in stops from middle grey. "
        "Clamped "
        "it rises ever more steeply and breaks off 2.5 stops over grey; a smoothstep begins later "
        "and ends at the same place; the film's curve has a toe, a straight line and a shoulder "
        "that ends 5.5 stops over grey.");
    svg_plot_frame(&plot, 1.0, 0.2, "stops from middle grey", "light that is shown");
    for (int curve = 0; curve < 3; curve++) {
        double point[POINTS][2];
        for (int i = 0; i < POINTS; i++) {
            point[i][0] = -6.0 + 12.0 * i / (POINTS - 1);
            point[i][1] = curves[curve](0.18 * exp2(point[i][0]));
        }
        svg_plot_curve(&plot, POINTS, (const double(*)[2])point,
                       (struct svg_pen){.stroke = colours[curve], .width = 2.4});
        svg_text(104.0, 60.0 + 20.0 * curve, 'l', 15.0, colours[curve], words[curve]);
    }
    double grey[2] = {svg_plot_x(&plot, 0.0), svg_plot_y(&plot, 0.18)};
    svg_circle(grey[0], grey[1], 4.5, (struct svg_pen){.fill = SVG_INK});
    svg_text(grey[0] - 14.0, grey[1] - 8.0, 'r', 15.0, SVG_INK, "middle grey stays");
    svg_end();
    return 0;
}
