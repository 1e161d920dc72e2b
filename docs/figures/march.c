// march.c - the report's figures 1 and 3: the march of one ray in the plane, with its numbers.
#include <math.h>

#include "svg.h"

// One scene unit is 82 pixels; the eye stands at the origin of the scene.
static const double unit = 82.0, eye_x = 118.0, eye_y = 142.0;
static const double balls[2][3] = {{3.35, 0.62, 0.62}, {0.8, -1.42, 0.38}}; // x, y, radius
static const double box[4] = {6.4, -0.62, 0.62, 0.75}; // x, y, half width, half height
static const double slope = -6.0;                      // degrees

static double page_x(double x)
{
    return eye_x + unit * x;
}

static double page_y(double y)
{
    return eye_y - unit * y;
}

static double distance(double x, double y)
{
    double to_balls = fmin(hypot(x - balls[0][0], y - balls[0][1]) - balls[0][2],
                           hypot(x - balls[1][0], y - balls[1][1]) - balls[1][2]);
    double qx = fabs(x - box[0]) - box[2], qy = fabs(y - box[1]) - box[3];
    double to_box = hypot(fmax(qx, 0.0), fmax(qy, 0.0)) + fmin(fmax(qx, qy), 0.0);
    return fmin(to_balls, to_box);
}

static void draw_scene(void)
{
    const struct svg_pen solid = {.stroke = SVG_BLUE, .width = 2.0, .fill = SVG_SKY};
    for (int i = 0; i < 2; i++)
        svg_circle(page_x(balls[i][0]), page_y(balls[i][1]), unit * balls[i][2], solid);
    const double left = page_x(box[0] - box[2]), right = page_x(box[0] + box[2]);
    const double top = page_y(box[1] + box[3]), bottom = page_y(box[1] - box[3]);
    const double corner[4][2] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
    svg_polygon(4, corner, solid);
    svg_text(page_x(balls[0][0]), page_y(balls[0][1]) + 5.0, 'm', 15.0, SVG_BLUE, "ball");
    svg_text(page_x(balls[1][0]), page_y(balls[1][1]) + 5.0, 'm', 15.0, SVG_BLUE, "ball");
    svg_text(page_x(box[0]) + 8.0, page_y(box[1]) + 28.0, 'm', 15.0, SVG_BLUE, "box");
}

static void draw_row(int step, double t, double d)
{
    double x = 84.0 + 76.0 * step;
    svg_textf(x, 352.0, 'm', 14.0, SVG_INK, "%d", step);
    svg_textf(x, 374.0, 'm', 14.0, SVG_INK, "%.3f", t);
    svg_textf(x, 396.0, 'm', 14.0, SVG_ORANGE, "%.3f", d);
}

int main(void)
{
    const double radians = slope * acos(-1.0) / 180.0;
    svg_begin(
        760.0, 412.0, "The march of one ray in the plane",
        "A ray starts at an eye on the left and passes between two balls before it meets a box on "
        "the "
        "right. Around each position of the march stands a circle that just touches the nearest "
        "solid; the next position is where the ray leaves that circle. The circles shrink beside "
        "the ball, grow behind it, and shrink again at the box. A table below gives t and the "
        "distance of each step.");
    draw_scene();
    double end_x = page_x(7.6 * cos(radians)), end_y = page_y(7.6 * sin(radians));
    svg_line(page_x(0.0), page_y(0.0), end_x, end_y,
             (struct svg_pen){.stroke = SVG_INK, .dash = "5 5"});
    double t = 0.0, at[12][2];
    int step = 0;
    for (bool found = false; !found && step < 12; step++) {
        double x = t * cos(radians), y = t * sin(radians), d = distance(x, y);
        found = d < 0.05;
        svg_circle(page_x(x), page_y(y), unit * d,
                   (struct svg_pen){.stroke = SVG_ORANGE, .width = 1.8});
        svg_circle(page_x(x), page_y(y), found ? 5.0 : 3.5, (struct svg_pen){.fill = SVG_INK});
        draw_row(step, t, d);
        at[step][0] = page_x(x);
        at[step][1] = page_y(y);
        t += found ? 0.0 : d;
    }
    for (int i = 0; i < step - 1; i++) { // on a ground of their own, over the circles
        svg_circle(at[i][0], at[i][1] - 15.0, 8.5, (struct svg_pen){.fill = SVG_PAPER});
        svg_textf(at[i][0], at[i][1] - 10.0, 'm', 14.0, SVG_INK, "%d", i);
    }
    svg_line(page_x(0.0), page_y(0.0), page_x(t * cos(radians)), page_y(t * sin(radians)),
             (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    svg_text(14.0, 352.0, 'l', 14.0, SVG_INK, "step");
    svg_text(14.0, 374.0, 'l', 14.0, SVG_INK, "<tspan font-style='italic'>t</tspan>");
    svg_text(14.0, 396.0, 'l', 14.0, SVG_ORANGE, "dist.");
    svg_end();
    return 0;
}
