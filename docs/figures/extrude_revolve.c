// extrude_revolve.c - from the plane to space: the right-angled triangle of an extrusion, and two
// revolved discs, whose parts beyond the axis (dashed) do not belong to the solids but still affect
// the formula's distance.
#include <math.h>
#include <stddef.h>

#include "svg.h"

static const double pi = 3.14159265358979323846;

// ---- Extrusion: x is the distance to the figure, y the position along the line ----

static void draw_extrusion(void)
{
    const double wall = 150.0, top = 140.0, floor_ = 300.0; // pixels
    const double body[4][2] = {{24.0, top}, {wall, top}, {wall, floor_}, {24.0, floor_}};
    svg_polygon(4, body, (struct svg_pen){.fill = SVG_SKY});
    svg_path(3, (const double[3][2]){{24.0, top}, {wall, top}, {wall, floor_}},
             (struct svg_pen){.stroke = SVG_BLUE, .width = 2.4});
    svg_line(wall, floor_, 24.0, floor_, (struct svg_pen){.stroke = SVG_BLUE, .width = 2.4});
    const struct svg_pen thin = {.stroke = SVG_PALE, .width = 1.0, .dash = "4 3"};
    svg_line(wall, top, wall, 70.0, thin);
    svg_line(wall, top, 236.0, top, thin);

    // Outside, beyond the edge, both distances count.
    const double p[2] = {218.0, 82.0};
    svg_line(wall, top, p[0], p[1], (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.4});
    svg_line(wall, p[1], p[0], p[1], (struct svg_pen){.stroke = SVG_INK, .width = 1.4});
    svg_line(p[0], top, p[0], p[1], (struct svg_pen){.stroke = SVG_INK, .width = 1.4});
    svg_circle(p[0], p[1], 4.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(184.0, 74.0, 'm', 14.0, SVG_INK, "q<tspan font-size='10' dy='3'>x</tspan>");
    svg_text(226.0, 116.0, 'l', 14.0, SVG_INK, "q<tspan font-size='10' dy='3'>y</tspan>");

    // Inside, the smaller depth counts.
    const double in[2] = {108.0, 196.0};
    svg_line(in[0], in[1], wall, in[1], (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.4});
    svg_line(in[0], in[1], in[0], top, thin);
    svg_circle(in[0], in[1], 4.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(128.0, 214.0, 'm', 14.0, SVG_INK, "&#8722;q<tspan font-size='10' dy='3'>x</tspan>");
    svg_text(100.0, 172.0, 'r', 14.0, SVG_INK, "&#8722;q<tspan font-size='10' dy='3'>y</tspan>");

    svg_text(87.0, 290.0, 'm', 13.0, SVG_BLUE, "a cross-section");
    svg_text(130.0, 326.0, 'm', 14.0, SVG_INK, "outside: Pythagoras,");
    svg_text(130.0, 344.0, 'm', 14.0, SVG_INK, "inside: the smaller depth");
}

// ---- Revolution: a disc of radius 1 around (centre, 0), rotated about the axis ----

struct panel {
    double x, y, unit; // the origin and the length of one unit, in pixels
};

static void to_page(const struct panel *panel, double x, double y, double page[2])
{
    page[0] = panel->x + panel->unit * x;
    page[1] = panel->y - panel->unit * y;
}

// Compute points on the disc's rim, from one angle to another.
static void arc_points(const struct panel *panel, double centre, double from, double to, int count,
                       double (*point)[2])
{
    for (int i = 0; i < count; i++) {
        double angle = from + (to - from) * i / (count - 1.0);
        to_page(panel, centre + cos(angle), sin(angle), point[i]);
    }
}

static void draw_turned(const struct panel *panel, double centre, double y)
{
    enum { POINTS = 90 };
    double point[POINTS][2], cross = acos(-centre);
    arc_points(panel, centre, -cross, cross, POINTS, point);
    svg_polygon(POINTS, (const double(*)[2])point, (struct svg_pen){.fill = SVG_SKY});
    arc_points(panel, centre, cross, 2.0 * pi - cross, POINTS, point);
    svg_path(POINTS, (const double(*)[2])point,
             (struct svg_pen){.stroke = SVG_PALE, .width = 1.6, .dash = "5 4"});
    arc_points(panel, centre, -cross, cross, POINTS, point);
    svg_path(POINTS, (const double(*)[2])point, (struct svg_pen){.stroke = SVG_BLUE, .width = 2.4});
    svg_line(panel->x, 56.0, panel->x, 306.0, (struct svg_pen){.stroke = SVG_INK, .width = 1.2});

    // Draw two circles, whose radii are the formula's distance and the true distance.
    double p[2], asked = fabs(hypot(centre, y) - 1.0), tip = sqrt(1.0 - centre * centre);
    double answer = fabs(y - tip);
    to_page(panel, 0.0, y, p);
    svg_circle(p[0], p[1], panel->unit * answer,
               (struct svg_pen){.stroke = SVG_TEAL, .width = 1.6, .dash = "2 3"});
    svg_circle(p[0], p[1], panel->unit * asked,
               (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0});
    svg_circle(p[0], p[1], 4.0, (struct svg_pen){.fill = SVG_INK});
    svg_textf(panel->x + 0.6 * panel->unit * centre, 326.0, 'm', 14.0, SVG_ORANGE, "formula: %.4f",
              asked);
    svg_textf(panel->x + 0.6 * panel->unit * centre, 344.0, 'm', 14.0, SVG_TEAL,
              "true distance: %.4f", answer);
}

int main(void)
{
    svg_begin(
        760.0, 360.0, "From the plane to space",
        "Left: a block, cut along the line of its extrusion. The distance of a point beyond its "
        "edge is the hypotenuse of a right-angled triangle, whose legs are the distance to the "
        "figure and the height above the end face. For a point inside, the smaller of two depths "
        "counts. Middle: a disc with its centre to the right of the axis; the part on the left is "
        "dashed. A circle around the origin touches the dashed rim long before the solid rim. "
        "Right: a disc with its centre to the left of the axis. A circle around a point above the "
        "tip touches the dashed rim before it reaches the tip.");
    svg_text(130.0, 30.0, 'm', 15.0, SVG_INK, "an extrusion");
    svg_text(386.0, 30.0, 'm', 15.0, SVG_INK, "an apple: too near inside");
    svg_text(648.0, 30.0, 'm', 15.0, SVG_INK, "a lemon: too near outside");
    draw_extrusion();
    draw_turned(&(struct panel){345.0, 184.0, 86.0}, 0.8, 0.0);
    draw_turned(&(struct panel){690.0, 204.0, 86.0}, -0.8, 1.0);
    svg_end();
    return 0;
}
