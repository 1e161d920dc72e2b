// projections.c - the report's figure 7: two equal boxes, seen with rays from one point and with
// parallel rays.
#include <stdio.h>

#include "svg.h"

static const double unit = 62.0;

struct view {
    double left, middle; // the x of the eye and the y of the view axis, in pixels
    double opening;      // 1 for rays from one point, 0 for parallel rays
};

static double page_x(const struct view *view, double z)
{
    return view->left + unit * z;
}

static double page_y(const struct view *view, double y)
{
    return view->middle - unit * y;
}

static void draw_box(const struct view *view, double z)
{
    const double l = page_x(view, z), r = page_x(view, z + 0.7), t = page_y(view, 0.5),
                 b = page_y(view, -0.5);
    const double corner[4][2] = {{l, t}, {r, t}, {r, b}, {l, b}};
    svg_polygon(4, corner, (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0, .fill = SVG_SKY});
}

// Draw the rays to the front edges of a box, and the image of the box on the screen at depth 1.
static void draw_rays(const struct view *view, double z, const char *colour, double width)
{
    double size = view->opening > 0.5 ? 0.5 / z : 0.5; // half the height of the image
    for (int side = -1; side <= 1; side += 2) {
        double start = view->opening > 0.5 ? 0.0 : 0.5 * side;
        svg_line(page_x(view, 0.0), page_y(view, start), page_x(view, z), page_y(view, 0.5 * side),
                 (struct svg_pen){.stroke = colour, .width = 1.6});
    }
    svg_line(page_x(view, 1.0), page_y(view, size), page_x(view, 1.0), page_y(view, -size),
             (struct svg_pen){.stroke = colour, .width = width});
}

static void draw_view(const struct view *view, const char *name, const char *words)
{
    draw_box(view, 2.2);
    draw_box(view, 4.0);
    svg_line(page_x(view, 1.0), page_y(view, 1.15), page_x(view, 1.0), page_y(view, -1.15),
             (struct svg_pen){.stroke = SVG_INK, .width = 1.5});
    svg_text(page_x(view, 1.0), page_y(view, 1.15) - 8.0, 'm', 14.0, SVG_INK, "screen");
    draw_rays(view, 4.0, SVG_TEAL, 9.0);
    draw_rays(view, 2.2, SVG_ORANGE, 4.0);
    if (view->opening > 0.5)
        svg_circle(page_x(view, 0.0), page_y(view, 0.0), 5.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(page_x(view, 0.0) - 20.0, 36.0, 'l', 16.0, SVG_INK, name);
    svg_text(page_x(view, 0.0) - 20.0, 280.0, 'l', 14.0, SVG_INK, words);
}

int main(void)
{
    svg_begin(
        760.0, 310.0, "Perspective and parallel projection",
        "Two diagrams of the same two boxes, which have equal heights and are at depths 2.2 and 4, "
        "with a screen at depth 1. On the left, the rays come from one point, and on the screen "
        "the farther box is smaller by the ratio of the depths. On the right, the rays are "
        "parallel, and both boxes have the same size on the screen.");
    const struct view perspective = {50.0, 160.0, 1.0}, orthographic = {430.0, 160.0, 0.0};
    draw_view(&perspective, "perspective", "sizes in the ratio 4 : 2.2, the inverse of the depths");
    draw_view(&orthographic, "orthographic", "equal sizes at every depth");
    svg_end();
    return 0;
}
