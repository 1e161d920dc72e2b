// shadow_rays.c - the report's figure 4: from where the ray of the eye ended, a ray towards the
// lamp.
#include <math.h>
#include <stdbool.h>

#include "svg.h"

static const double unit = 88.0, left = 40.0, ground = 412.0;
static const double lamp[2] = {5.6, 3.3}, eye[2] = {0.15, 2.2}, ball[3] = {4.15, 1.72, 0.52};

static double page_x(double x)
{
    return left + unit * x;
}

static double page_y(double y)
{
    return ground - unit * y;
}

static double distance(double x, double y)
{
    return fmin(hypot(x - ball[0], y - ball[1]) - ball[2], y);
}

static bool near(double x, double y)
{
    return distance(x, y) < 0.03;
}

// Every circle of the march from (x, 0.12) to the lamp, and the ray as far as it goes.
static void ask_for_lamp(double x)
{
    double length = hypot(lamp[0] - x, lamp[1] - 0.12);
    double ux = (lamp[0] - x) / length, uy = (lamp[1] - 0.12) / length, t = 0.0;
    double marks[64];
    int count = 0;
    while (count < 64 && t < length && !near(x + t * ux, 0.12 + t * uy)) {
        marks[count++] = t;
        t += distance(x + t * ux, 0.12 + t * uy);
    }
    bool hidden = t < length;
    const char *colour = hidden ? SVG_BLUE : SVG_ORANGE;
    for (int i = 0; i < count; i++) {
        double px = x + marks[i] * ux, py = 0.12 + marks[i] * uy;
        svg_circle(page_x(px), page_y(py), unit * distance(px, py),
                   (struct svg_pen){.stroke = colour, .width = 1.0, .opacity = 0.6});
        svg_circle(page_x(px), page_y(py), 2.5, (struct svg_pen){.fill = colour});
    }
    t = fmin(t, length);
    svg_arrow(page_x(x), page_y(0.12), page_x(x + t * ux), page_y(0.12 + t * uy),
              (struct svg_pen){.stroke = colour, .width = 2.4});
}

static void look(double x, const char *name)
{
    svg_arrow(page_x(eye[0]), page_y(eye[1]), page_x(x), page_y(0.0),
              (struct svg_pen){.stroke = SVG_INK, .width = 1.5});
    ask_for_lamp(x);
    svg_circle(page_x(x), page_y(0.0), 4.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(page_x(x), page_y(0.0) + 24.0, 'm', 15.0, SVG_INK, name);
}

int main(void)
{
    svg_begin(
        760.0, 462.0, "Two rays towards the lamp",
        "An eye on the left looks at two points of the ground, P and Q. From a little above each a "
        "second ray is marched towards the lamp, with its circles. The ray from Q, right of a "
        "ball, "
        "reaches the lamp. The ray from P stops at the ball that stands between: P is in shadow.");
    svg_line(page_x(-0.3), page_y(0.0), page_x(8.0), page_y(0.0),
             (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0});
    svg_circle(page_x(ball[0]), page_y(ball[1]), unit * ball[2],
               (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0, .fill = SVG_SKY});
    look(2.5, "P, in shadow");
    look(6.6, "Q, lit");
    svg_circle(page_x(lamp[0]), page_y(lamp[1]), 11.0,
               (struct svg_pen){.stroke = SVG_ORANGE, .fill = SVG_SAND, .width = 2.5});
    svg_text(page_x(lamp[0]) + 18.0, page_y(lamp[1]) + 5.0, 'l', 15.0, SVG_INK, "lamp");
    svg_circle(page_x(eye[0]), page_y(eye[1]), 5.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(page_x(eye[0]), page_y(eye[1]) - 12.0, 'm', 15.0, SVG_INK, "eye");
    svg_end();
    return 0;
}
