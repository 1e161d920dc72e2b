// ball_caustic.c - parallel rays through a ball of glass, and the curve that they all touch.
#include "../../tests/support_glass.h"
#include "svg.h"

enum { POINTS = 200 };

static const double index_of = 1.5168, unit = 120.0;

static double px(double z)
{
    return 250.0 + unit * z;
}

static double py(double r)
{
    return 165.0 - unit * r;
}

// The line of a ray behind the ball is z sin(D) + r cos(D) = sin(i). With its derivative in i this
// gives the point where it touches its neighbours.
static void touch(double i, double point[2])
{
    double j = asin(sin(i) / index_of), turn = 2.0 * (i - j);
    double part = cos(i) / (2.0 * (1.0 - cos(i) / (index_of * cos(j))));
    point[0] = sin(i) * sin(turn) + part * cos(turn);
    point[1] = sin(i) * cos(turn) - part * sin(turn);
}

static void ray(double b)
{
    double i = asin(fabs(b)), j = asin(fabs(b) / index_of), turn = 2.0 * (i - j),
           s = b < 0.0 ? -1.0 : 1.0;
    double out = i - turn, end = 3.6, r = (sin(i) - end * sin(turn)) / cos(turn);
    const struct svg_pen pen = {.stroke = SVG_INK, .width = 0.9};
    svg_line(px(-1.9), py(b), px(-cos(i)), py(b), pen);
    svg_line(px(-cos(i)), py(b), px(cos(out)), py(s * sin(out)), pen);
    if (fabs(r) > 1.3) {
        r = r < 0.0 ? -1.3 : 1.3;
        end = (sin(i) - r * cos(turn)) / sin(turn);
    }
    svg_line(px(cos(out)), py(s * sin(out)), px(end), py(s * r), pen);
}

int main(void)
{
    svg_begin(760.0, 330.0, "The caustic of a ball",
              "Parallel rays from the left go through a disc and cross behind it. Two curves from "
              "the rim "
              "meet in a cusp on the axis, 1.47 radii behind the middle: all rays touch them.");
    svg_circle(px(0.0), py(0.0), unit,
               (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0, .fill = SVG_SKY});
    for (int k = -12; k <= 12; k++)
        ray(0.92 * k / 12.0);
    for (int side = -1; side <= 1; side += 2) {
        double point[POINTS][2];
        int count = 0;
        for (int k = 1; k < POINTS; k++) {
            double at[2];
            touch(1.30 * k / POINTS, at);
            if (hypot(at[0], at[1]) < 1.0)
                break;
            point[count][0] = px(at[0]);
            point[count++][1] = py(side * at[1]);
        }
        svg_path(count, (const double(*)[2])point,
                 (struct svg_pen){.stroke = SVG_ORANGE, .width = 3.2});
    }
    svg_text(24.0, 24.0, 'l', 15.0, SVG_ORANGE, "the caustic: the curve that all rays touch");
    svg_end();
    return 0;
}
