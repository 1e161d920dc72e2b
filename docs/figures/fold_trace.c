// fold_trace.c - one point through two folds: a triangle cut in four, its lower corners' mirrors,
// and where the point goes. All numbers are computed with the fold's own formula.
#include <math.h>
#include <stdbool.h>

#include "svg.h"

#define RISE 1.7320508 // height of the triangle, whose side is 2

// A mirror's normal in words, and what follows on the line.
#define NORMAL(number, after)                                                                      \
    "n<tspan font-size='10' dy='3'>" number "</tspan><tspan dy='-3'>" after "</tspan>"

struct point {
    double x, y;
};

// The page: the triangle's upper corner stands at the origin.
static const double unit = 190.0, middle = 232.0, top = 74.0;

static double page_x(struct point p)
{
    return middle + unit * p.x;
}

static double page_y(struct point p)
{
    return top - unit * p.y;
}

// How far p stands in front of the mirror with the normal n, whose offset is 1.
static double height(struct point p, struct point n)
{
    return n.x * p.x + n.y * p.y + 1.0;
}

static struct point fold(struct point p, struct point n)
{
    double behind = fmin(height(p, n), 0.0);
    return (struct point){p.x - 2.0 * behind * n.x, p.y - 2.0 * behind * n.y};
}

// A triangle of side 1 below its upper corner.
static void draw_copy(struct point corner, const char *fill, const char *stroke)
{
    const struct point p[3] = {
        corner, {corner.x + 0.5, corner.y - 0.5 * RISE}, {corner.x - 0.5, corner.y - 0.5 * RISE}};
    double page[3][2];
    for (int k = 0; k < 3; k++) {
        page[k][0] = page_x(p[k]);
        page[k][1] = page_y(p[k]);
    }
    svg_polygon(3, (const double(*)[2])page,
                (struct svg_pen){.fill = fill, .stroke = stroke, .width = 1.0});
}

// A mirror through the foot nearest to the origin, with its normal.
static void draw_mirror(struct point n, double before, double behind, const char *name, double x)
{
    struct point foot = {-n.x, -n.y}, along = {n.y, -n.x};
    struct point a = {foot.x + before * along.x, foot.y + before * along.y};
    struct point b = {foot.x + behind * along.x, foot.y + behind * along.y};
    struct point from = {foot.x + x * along.x, foot.y + x * along.y};
    struct point tip = {from.x + 0.2 * n.x, from.y + 0.2 * n.y};
    svg_line(page_x(a), page_y(a), page_x(b), page_y(b),
             (struct svg_pen){.stroke = SVG_INK, .width = 1.4, .dash = "7 5"});
    svg_arrow(page_x(from), page_y(from), page_x(tip), page_y(tip),
              (struct svg_pen){.stroke = SVG_INK, .width = 1.6});
    svg_text(page_x(tip), page_y(tip) - 8.0, 'm', 15.0, SVG_INK, name);
}

static void draw_point(struct point p, double dx, double dy, const char *name)
{
    svg_circle(page_x(p), page_y(p), 4.5, (struct svg_pen){.fill = SVG_ORANGE, .stroke = SVG_INK});
    svg_text(page_x(p) + dx, page_y(p) + dy, 'l', 17.0, SVG_INK, name);
}

static void draw_step(struct point from, struct point to)
{
    double x = page_x(to) - page_x(from), y = page_y(to) - page_y(from);
    double gap = 8.0 / hypot(x, y);
    svg_arrow(page_x(from) + gap * x, page_y(from) + gap * y, page_x(to) - gap * x,
              page_y(to) - gap * y, (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.2});
}

static void write_place(double y, const char *name, struct point p)
{
    svg_textf(470.0, y, 'l', 15.0, SVG_INK, "%s = (%.3f, −%.3f)", name, p.x, -p.y);
}

// What the page says in words, in the order in which it is found.
static void write_numbers(struct point p, struct point once, struct point twice, double first,
                          double second)
{
    write_place(112.0, "p", p);
    svg_textf(470.0, 142.0, 'l', 15.0, SVG_INK, NORMAL("1", " · p + 1 = −%.3f: behind"), -first);
    write_place(188.0, "p′", once);
    svg_textf(470.0, 218.0, 'l', 15.0, SVG_INK, NORMAL("2", " · p′ + 1 = −%.3f: behind"), -second);
    write_place(264.0, "p″", twice);
    svg_textf(470.0, 310.0, 'l', 15.0, SVG_INK, "from p″ to the dark triangle: %.3f",
              0.5 * (RISE * twice.x + twice.y));
    svg_textf(470.0, 340.0, 'l', 15.0, SVG_INK, "from p to all three: %.3f", -p.y - RISE);
}

int main(void)
{
    const struct point n1 = {0.5, 0.5 * RISE}, n2 = {-0.5, 0.5 * RISE};
    const struct point p = {0.3, -1.9}, once = fold(p, n1), twice = fold(once, n2);
    svg_begin(
        760.0, 480.0, "One point through two folds",
        "A triangle without its middle quarter, and two mirrors, each halfway between the upper "
        "corner and a lower one. A point below the triangle is reflected in the first mirror, "
        "then in the second, and arrives beside the upper of the three small triangles.");
    svg_text(24.0, 36.0, 'l', 16.0, SVG_INK, "One point through two folds");
    draw_copy((struct point){-0.5, -0.5 * RISE}, SVG_SKY, SVG_PALE);
    draw_copy((struct point){0.5, -0.5 * RISE}, SVG_SKY, SVG_PALE);
    draw_copy((struct point){0.0, 0.0}, SVG_BLUE, SVG_BLUE);
    draw_mirror(n1, -0.62, 1.30, NORMAL("1", ""), -0.55);
    draw_mirror(n2, -1.30, 0.62, NORMAL("2", ""), 0.55);
    draw_step(p, once);
    draw_step(once, twice);
    draw_point(p, 12.0, 10.0, "p");
    draw_point(once, 12.0, 10.0, "p′");
    draw_point(twice, 12.0, -4.0, "p″");
    write_numbers(p, once, twice, height(p, n1), height(once, n2));
    svg_end();
    return 0;
}
