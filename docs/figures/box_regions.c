// box_regions.c - the distance to a box, region by region: two cuts through one octant, one through
// the centre of the box and one in front of the box. Some points are labelled with their q and
// their distance.
#include <math.h>

#include "svg.h"

static const double half[3] = {1.2, 0.8, 1.0};

// A cut: the position of its corner x = y = 0 on the page, in pixels, its z, and its title.
struct cut {
    double left, bottom, z;
    const char *title;
};

static const double unit = 126.0, reach_x = 2.6, reach_y = 1.8;

static double page_x(const struct cut *cut, double x)
{
    return cut->left + unit * x;
}

static double page_y(const struct cut *cut, double y)
{
    return cut->bottom - unit * y;
}

static void draw_rectangle(const struct cut *cut, const double from[2], const double to[2],
                           struct svg_pen pen)
{
    const double x[2] = {page_x(cut, from[0]), page_x(cut, to[0])};
    const double y[2] = {page_y(cut, from[1]), page_y(cut, to[1])};
    const double corner[4][2] = {{x[0], y[0]}, {x[1], y[0]}, {x[1], y[1]}, {x[0], y[1]}};
    svg_polygon(4, corner, pen);
}

// Draw the regions of the cut. The number of faces that a region is beyond determines its colour.
static void draw_regions(const struct cut *cut)
{
    static const char *const shade[] = {SVG_SKY, SVG_SAND, SVG_TEAL, SVG_ORANGE};
    static const double strength[] = {1.0, 0.75, 0.22, 0.35};
    const int front = cut->z > half[2];
    for (int i = 0; i < 4; i++) {
        const double from[2] = {i % 2 ? half[0] : 0.0, i / 2 ? half[1] : 0.0};
        const double to[2] = {i % 2 ? reach_x : half[0], i / 2 ? reach_y : half[1]};
        int beyond = i % 2 + i / 2 + front;
        draw_rectangle(cut, from, to,
                       (struct svg_pen){.fill = shade[beyond], .opacity = strength[beyond]});
    }
    const double origin[2] = {0.0, 0.0};
    draw_rectangle(
        cut, origin, half,
        (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0, .dash = front ? "6 4" : "none"});
    svg_textf(cut->left, cut->bottom - unit * reach_y - 12.0, 'l', 15.0, SVG_INK, "%s", cut->title);
    svg_text(page_x(cut, reach_x), cut->bottom + 17.0, 'r', 14.0, SVG_INK,
             "<tspan font-style='italic'>x</tspan>");
    svg_text(cut->left - 8.0, page_y(cut, reach_y) + 12.0, 'r', 14.0, SVG_INK,
             "<tspan font-style='italic'>y</tspan>");
}

// Draw the contour at a distance of 0.5: a line segment, an arc and a second line segment.
static void draw_level(const struct cut *cut)
{
    enum { ARC = 32 };
    const double over = fmax(cut->z - half[2], 0.0), aside = sqrt(0.25 - over * over);
    double point[ARC + 3][2];
    point[0][0] = page_x(cut, half[0] + aside);
    point[0][1] = page_y(cut, 0.0);
    for (int i = 0; i <= ARC; i++) {
        double turn = acos(-1.0) / 2.0 * i / ARC;
        point[i + 1][0] = page_x(cut, half[0] + aside * cos(turn));
        point[i + 1][1] = page_y(cut, half[1] + aside * sin(turn));
    }
    point[ARC + 2][0] = page_x(cut, 0.0);
    point[ARC + 2][1] = page_y(cut, half[1] + aside);
    svg_text(cut->left + 8.0, page_y(cut, half[1] + aside) - 7.0, 'l', 13.0, SVG_INK,
             "at a distance of 0.5");
    svg_path(ARC + 3, (const double(*)[2])point,
             (struct svg_pen){.stroke = SVG_PALE, .width = 1.4});
}

static const char *minus(double number)
{
    return number < 0.0 ? "&#8722;" : "";
}

// Draw a point, its label, and the line to the nearest point on the surface.
//   name_x, name_y  position of the label relative to the point, in pixels
static void draw_point(const struct cut *cut, double x, double y, const char *name, double name_x,
                       double name_y)
{
    const double p[3] = {x, y, cut->z};
    double q[3], nearest[3], square = 0.0;
    int largest = 0;
    for (int i = 0; i < 3; i++) {
        q[i] = p[i] - half[i];
        nearest[i] = fmin(p[i], half[i]);
        square += fmax(q[i], 0.0) * fmax(q[i], 0.0);
        largest = q[i] > q[largest] ? i : largest;
    }
    const double distance = sqrt(square) + fmin(q[largest], 0.0);
    if (distance < 0.0)
        nearest[largest] = half[largest];
    const double px = page_x(cut, x), py = page_y(cut, y);
    const double nx = page_x(cut, nearest[0]), ny = page_y(cut, nearest[1]);
    svg_line(px, py, nx, ny, (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.4});
    svg_circle(nx, ny, 3.6,
               (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0, .fill = SVG_PAPER});
    svg_circle(px, py, 4.0, (struct svg_pen){.fill = SVG_INK});
    svg_textf(px + name_x, py + name_y, 'm', 14.0, SVG_INK,
              "%s: <tspan font-weight='bold'>%s%.1f</tspan>", name, minus(distance),
              fabs(distance));
    svg_textf(px + name_x, py + name_y + 16.0, 'm', 12.0, SVG_INK,
              "<tspan font-style='italic'>q</tspan> = (%s%.1f, %s%.1f, %s%.1f)", minus(q[0]),
              fabs(q[0]), minus(q[1]), fabs(q[1]), minus(q[2]), fabs(q[2]));
}

int main(void)
{
    const struct cut middle = {26.0, 266.0, 0.0, "cut through the centre, z = 0"};
    const struct cut front = {412.0, 266.0, 1.3, "cut in front of the box, z = 1.3"};
    svg_begin(
        760.0, 294.0, "The distance to a box, region by region",
        "Two cuts through the octant of a box in which x, y and z are positive. The half sizes of "
        "the box are 1.2, 0.8 and 1. On the left the cut passes through the centre of the box: "
        "inside, the nearest point is on the nearest face; beside a face, it is the foot of the "
        "perpendicular to that face; beyond two faces, it is on their common edge. On the right "
        "the cut passes in front of the box: opposite the front face, the nearest point is on "
        "that face; beyond one side, it is on an edge; beyond two sides, it is the corner. A line "
        "at a distance of 0.5 is straight beside the sides and curves around the corner in an "
        "arc.");
    draw_regions(&middle);
    draw_level(&middle);
    draw_point(&middle, 0.9, 0.42, "inside", -38.0, 24.0);
    draw_point(&middle, 1.7, 0.42, "face", 58.0, -4.0);
    draw_point(&middle, 1.5, 1.2, "edge", 70.0, -16.0);
    draw_regions(&front);
    draw_level(&front);
    draw_point(&front, 0.6, 0.42, "face", 0.0, 24.0);
    draw_point(&front, 1.6, 0.42, "edge", 62.0, -4.0);
    draw_point(&front, 1.8, 1.0, "corner", 34.0, -28.0);
    svg_end();
    return 0;
}
