// sky_error.c - the error of the visible share of the sky, beside a ball on a floor, against the
// number of rays. A point of the unit disc, projected up onto the hemisphere, is the direction of a
// ray. Either all points are random over the whole disc, or each cell of the disc has one random
// point.
#include <math.h>
#include <stddef.h>

#include "lib/random.h"
#include "svg.h"

enum { SIDES = 7, TRIES = 3000, CURVES = 2 };

static const int sides[SIDES] = {1, 2, 3, 4, 6, 8, 12};
static const double pi = 3.14159265358979323846;

// Returns 1 if a ray from the floor reaches the sky, otherwise 0. The ray starts at the distance
// `away` from the point where a ball of radius 1 touches the floor; u and v, from 0 to 1, determine
// its direction.
static double reaches(double u, double v, double away)
{
    double x = sqrt(u) * cos(2.0 * pi * v), y = sqrt(1.0 - u);
    double along = -away * x + y, square = away * away + 1.0 - along * along;
    return along > 0.0 && square < 1.0 ? 0.0 : 1.0;
}

// One estimate: the mean over side x side rays.
static double estimate(int curve, int side, int attempt, double away)
{
    double sum = 0.0;
    for (int i = 0; i < side * side; i++) {
        double u = random_of(attempt, 14, 0, 2 * i), v = random_of(attempt, 14, 0, 2 * i + 1);
        if (curve == 1) {
            u = (i % side + u) / side;
            v = (i / side + v) / side;
        }
        sum += reaches(u, v, away);
    }
    return sum / (side * side);
}

// The root mean square error over many points of the floor.
static double error_of(int curve, int side)
{
    double squares = 0.0;
    for (int attempt = 0; attempt < TRIES; attempt++) {
        double away = 0.3 + 1.7 * (attempt + 0.5) / TRIES;
        double off = estimate(curve, side, attempt, away) - 1.0 + pow(1.0 + away * away, -1.5);
        squares += off * off;
    }
    return sqrt(squares / TRIES);
}

// The slope of the least-squares line through the logarithms of the points with at least 4 rays.
static double slope_of(const double (*point)[2])
{
    double n = SIDES - 1, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (int i = 1; i < SIDES; i++) {
        double a = log(point[i][0]), b = log(point[i][1]);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

int main(void)
{
    static const char *const colours[CURVES] = {SVG_ORANGE, SVG_BLUE};
    static const char *const words[CURVES] = {"random rays", "one ray per cell"};
    struct svg_plot plot = {90.0, 30.0, 620.0, 300.0, {1.0, 200.0}, {0.01, 1.0}, true, true};
    svg_begin(
        760.0, 400.0, "The error of the openness against the number of rays",
        "Two falling lines on logarithmic scales: the line for random rays falls more slowly than "
        "the line for one ray per cell.");
    svg_plot_frame(&plot, 1.0, 1.0, "number of rays", "error of the share");
    for (int curve = 0; curve < CURVES; curve++) {
        double point[SIDES][2];
        for (int i = 0; i < SIDES; i++) {
            point[i][0] = sides[i] * sides[i];
            point[i][1] = error_of(curve, sides[i]);
            svg_circle(svg_plot_x(&plot, point[i][0]), svg_plot_y(&plot, point[i][1]), 4.0,
                       (struct svg_pen){.fill = colours[curve]});
        }
        svg_plot_curve(&plot, SIDES, (const double(*)[2])point,
                       (struct svg_pen){.stroke = colours[curve], .width = 2.0});
        svg_textf(470.0, 70.0 + 24.0 * curve, 'l', 15.0, colours[curve], "%s: slope %.2f",
                  words[curve], slope_of((const double(*)[2])point));
    }
    svg_end();
    return 0;
}
