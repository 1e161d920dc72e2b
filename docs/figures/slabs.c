// slabs.c - a box is where two slabs overlap, and a ray is in it where its two intervals do.
#include <math.h>

#include "svg.h"

struct interval {
    double entry, leave;
};

static const double unit = 60.0, left = 132.0, ground = 326.0; // the page's place of (0, 0)
static const double origin[2] = {-1.0, 0.5}, direction[2] = {0.8, 0.6}, high[2] = {4.0, 2.0};
static const double axis_left = 510.0, axis_unit = 31.0; // the axis of t, at t = 0

static double page_x(double x)
{
    return left + unit * x;
}

static double page_y(double y)
{
    return ground - unit * y;
}

static double axis_x(double t)
{
    return axis_left + axis_unit * t;
}

static void draw_rectangle(double x0, double y0, double x1, double y1, struct svg_pen pen)
{
    const double corners[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    svg_polygon(4, corners, pen);
}

// The slab 0 to high along an axis of the plane.
static struct interval slab(int axis)
{
    return (struct interval){-origin[axis] / direction[axis],
                             (high[axis] - origin[axis]) / direction[axis]};
}

static void draw_scene(void)
{
    const double top = 46.0, bottom = 376.0, near = 36.0, far = 424.0;
    draw_rectangle(page_x(0.0), top, page_x(high[0]), bottom, (struct svg_pen){.fill = SVG_SKY});
    draw_rectangle(near, page_y(0.0), far, page_y(high[1]),
                   (struct svg_pen){.fill = SVG_SAND, .opacity = 0.8});
    for (int i = 0; i < 2; i++) {
        svg_line(page_x(i * high[0]), top, page_x(i * high[0]), bottom,
                 (struct svg_pen){.stroke = SVG_BLUE, .width = 1.6});
        svg_line(near, page_y(i * high[1]), far, page_y(i * high[1]),
                 (struct svg_pen){.stroke = SVG_ORANGE, .width = 1.6});
    }
    draw_rectangle(page_x(0.0), page_y(0.0), page_x(high[0]), page_y(high[1]),
                   (struct svg_pen){.stroke = SVG_INK, .width = 2.4});
    svg_text(page_x(high[0]) - 8.0, bottom - 12.0, 'r', 14.0, SVG_BLUE, "slab of x");
    svg_text(near + 6.0, page_y(high[1]) + 20.0, 'l', 14.0, SVG_ORANGE, "slab of y");
    svg_text(page_x(high[0]) - 10.0, page_y(0.0) - 12.0, 'r', 14.0, SVG_INK, "box");
}

static void mark(double t, const char *colour, double aside, char anchor)
{
    double x = page_x(origin[0] + t * direction[0]), y = page_y(origin[1] + t * direction[1]);
    svg_circle(x, y, 4.5, (struct svg_pen){.fill = colour});
    svg_textf(x + aside, y + (aside > 0.0 ? 16.0 : -9.0), anchor, 14.0, colour, "%.2f", t);
}

static void draw_ray(struct interval x, struct interval y)
{
    double end = x.leave + 0.45;
    svg_arrow(page_x(origin[0]), page_y(origin[1]), page_x(origin[0] + end * direction[0]),
              page_y(origin[1] + end * direction[1]), (struct svg_pen){.stroke = SVG_INK});
    svg_line(page_x(origin[0] + x.entry * direction[0]), page_y(origin[1] + x.entry * direction[1]),
             page_x(origin[0] + y.leave * direction[0]), page_y(origin[1] + y.leave * direction[1]),
             (struct svg_pen){.stroke = SVG_TEAL, .width = 6.0});
    svg_circle(page_x(origin[0]), page_y(origin[1]), 5.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(page_x(origin[0]) - 4.0, page_y(origin[1]) + 22.0, 'm', 15.0, SVG_INK, "O");
    mark(x.entry, SVG_BLUE, 8.0, 'l');
    mark(y.leave, SVG_ORANGE, 8.0, 'l');
    mark(x.leave, SVG_BLUE, -9.0, 'r');
}

static void draw_interval(double y, struct interval in, const char *colour, const char *words)
{
    draw_rectangle(axis_x(in.entry), y, axis_x(in.leave), y + 20.0,
                   (struct svg_pen){.fill = colour});
    svg_textf(axis_x(in.entry), y - 7.0, 'l', 14.0, colour, "%s: %.2f to %.2f", words, in.entry,
              in.leave);
}

int main(void)
{
    const struct interval x = slab(0), y = slab(1);
    const struct interval both = {fmax(fmax(x.entry, y.entry), 0.0), fmin(x.leave, y.leave)};
    svg_begin(
        760.0, 404.0, "A box is the overlap of slabs",
        "Left: a vertical band, the slab of x, and a horizontal one, the slab of y, overlap in "
        "a box. A ray from O enters the first at 1.25 and leaves it at 6.25; it begins in the "
        "second and leaves it at 2.5. Right: the two intervals as bars along t, and their "
        "overlap, from 1.25 to 2.5, where the ray is in the box.");
    draw_scene();
    draw_ray(x, y);
    for (int t = -1; t <= 7; t++) {
        svg_line(axis_x(t), 312.0, axis_x(t), 320.0,
                 (struct svg_pen){.stroke = SVG_INK, .width = 1.0});
        svg_textf(axis_x(t), 336.0, 'm', 13.0, SVG_INK, "%d", t);
    }
    svg_line(axis_x(-1.0), 316.0, axis_x(7.0), 316.0,
             (struct svg_pen){.stroke = SVG_INK, .width = 1.0});
    svg_text(axis_x(3.0), 360.0, 'm', 14.0, SVG_INK, "t along the ray");
    draw_interval(150.0, x, SVG_BLUE, "slab of x");
    draw_interval(216.0, y, SVG_ORANGE, "slab of y");
    draw_interval(282.0, both, SVG_TEAL, "box");
    svg_end();
    return 0;
}
