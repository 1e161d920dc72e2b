// other_point.c - a plank that was turned and moved, a point, and the other point: the same place
// as the plank sees it. The way back undoes the motion, last step first.
#include <math.h>

#include "svg.h"

struct point {
    double x, y;
};

static const double half_length = 2.0, half_width = 0.5, unit = 52.0;

// A page of its own: where its origin stands, in pixels.
struct ground {
    double x, y;
};

static double page_x(struct ground ground, struct point p)
{
    return ground.x + unit * p.x;
}

static double page_y(struct ground ground, struct point p)
{
    return ground.y - unit * p.y;
}

static struct point turned(struct point p, double degrees)
{
    double angle = degrees * acos(-1.0) / 180.0;
    return (struct point){cos(angle) * p.x - sin(angle) * p.y, sin(angle) * p.x + cos(angle) * p.y};
}

static void draw_axes(struct ground ground, double low, double high, double left, double right)
{
    struct svg_pen pen = {.stroke = SVG_PALE, .width = 1.2};
    svg_arrow(page_x(ground, (struct point){left, 0.0}), ground.y,
              page_x(ground, (struct point){right, 0.0}), ground.y, pen);
    svg_arrow(ground.x, page_y(ground, (struct point){0.0, low}), ground.x,
              page_y(ground, (struct point){0.0, high}), pen);
}

static void draw_plank(struct ground ground, double degrees, struct point place)
{
    const double sign[4][2] = {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}};
    double page[4][2];
    for (int k = 0; k < 4; k++) {
        struct point corner =
            turned((struct point){sign[k][0] * half_length, sign[k][1] * half_width}, degrees);
        corner = (struct point){corner.x + place.x, corner.y + place.y};
        page[k][0] = page_x(ground, corner);
        page[k][1] = page_y(ground, corner);
    }
    svg_polygon(4, (const double(*)[2])page,
                (struct svg_pen){.fill = SVG_SKY, .stroke = SVG_BLUE, .width = 1.4});
}

static void draw_point(struct ground ground, struct point p, double dx, double dy, char anchor,
                       const char *name)
{
    svg_circle(page_x(ground, p), page_y(ground, p), 4.5,
               (struct svg_pen){.fill = SVG_ORANGE, .stroke = SVG_INK});
    svg_textf(page_x(ground, p) + dx, page_y(ground, p) + dy, anchor, 15.0, SVG_INK,
              "%s (%.0f, %.0f)", name, p.x, p.y);
}

int main(void)
{
    const struct ground world = {84.0, 300.0}, own = {545.0, 246.0};
    const struct point place = {3.0, 1.0}, p = {3.0, 4.0};
    const struct point back = {p.x - place.x, p.y - place.y}, other = turned(back, -90.0);
    svg_begin(760.0, 380.0, "Ask the other point",
              "Left a plank that was turned by 90 degrees and moved to (3, 1); the point (3, 4) is "
              "one unit above its end. Right the plank as it was made, along the x axis: the same "
              "place is now (3, 0), one unit beyond its end.");
    svg_text(24.0, 36.0, 'l', 16.0, SVG_INK, "In the scene");
    svg_text(410.0, 36.0, 'l', 16.0, SVG_INK, "As the plank sees it");
    draw_plank(world, 90.0, place);
    draw_plank(own, 0.0, (struct point){0.0, 0.0});
    draw_axes(world, -0.8, 4.6, -0.8, 4.9);
    draw_axes(own, -1.4, 1.8, -2.6, 3.6);
    svg_circle(page_x(world, place), page_y(world, place), 3.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(page_x(world, place) + 34.0, page_y(world, place) + 5.0, 'l', 15.0, SVG_INK,
             "v (3, 1)");
    draw_point(world, p, 12.0, 2.0, 'l', "p");
    draw_point(own, other, 0.0, -14.0, 'm', "q");
    svg_textf(410.0, 100.0, 'l', 15.0, SVG_INK, "moved back: (%.0f, %.0f)", back.x, back.y);
    svg_text(410.0, 126.0, 'l', 15.0, SVG_INK, "then turned back by 90°: q");
    svg_end();
    return 0;
}
