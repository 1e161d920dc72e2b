// glass_path.c - a ray through a ball of glass: the circles of the march outside and, by minus the
// distance, inside; where it enters, where it leaves, and the part that is mirrored.
#include "../../tests/support_glass.h"
#include "svg.h"

static const double middle_x = 430.0, middle_y = 185.0, unit = 140.0;

static double px(double x)
{
    return middle_x + unit * x;
}

static double py(double y)
{
    return middle_y - unit * y;
}

static double ball(struct d3 p)
{
    return d3_length(p) - 1.0;
}

static void line(struct d3 a, struct d3 b, struct svg_pen pen)
{
    svg_line(px(a.x), py(a.y), px(b.x), py(b.y), pen);
}

// The circles of one march: down to a pixel.
static struct d3 march(struct mirror_ray ray, double side, const char *colour)
{
    double t = 0.0;
    for (int step = 0; step < 60; step++) {
        struct d3 p = mirror_at(ray, t);
        double d = side * ball(p);
        if (d < 0.004)
            break;
        svg_circle(px(p.x), py(p.y), d * unit, (struct svg_pen){.stroke = colour, .width = 1.2});
        svg_circle(px(p.x), py(p.y), 2.2, (struct svg_pen){.fill = SVG_INK});
        t += d;
    }
    return mirror_at(ray, t);
}

// The angle between two directions at a point, degrees: an arc, and its letter outside it.
static void angle(struct d3 at, double from, double to, double radius, const char *letter)
{
    enum { POINTS = 25 };
    double point[POINTS][2], middle = 0.5 * (from + to) * MIRROR_PI / 180.0;
    for (int k = 0; k < POINTS; k++) {
        double a = (from + (to - from) * k / (POINTS - 1)) * MIRROR_PI / 180.0;
        point[k][0] = px(at.x + radius * cos(a));
        point[k][1] = py(at.y + radius * sin(a));
    }
    svg_path(POINTS, (const double(*)[2])point, (struct svg_pen){.stroke = SVG_INK, .width = 1.2});
    radius += 0.11;
    svg_text(px(at.x + radius * cos(middle)), py(at.y + radius * sin(middle)) + 5.0, 'm', 16.0,
             SVG_INK, letter);
}

static double degrees(struct d3 direction)
{
    return atan2(direction.y, direction.x) * 180.0 / MIRROR_PI;
}

int main(void)
{
    const double index = 1.5, height = 0.72;
    const struct svg_pen ray_pen = {.stroke = SVG_INK, .width = 2.2};
    const struct svg_pen pale = {.stroke = SVG_ORANGE, .width = 1.6, .dash = "5 4"};
    const struct svg_pen normal_pen = {.stroke = SVG_PALE, .width = 1.2, .dash = "2 4"};
    svg_begin(
        760.0, 370.0, "A ray through a ball of glass",
        "A ray from the left walks by circles to a disc, bends towards the axis, walks by circles "
        "that touch the disc from inside, and bends again where it leaves. Dashed: what is "
        "mirrored at both places.");
    svg_circle(px(0.0), py(0.0), unit,
               (struct svg_pen){.stroke = SVG_BLUE, .width = 2.2, .fill = SVG_SKY});
    struct mirror_ray ray = {d3(-2.2, height, 0.0), d3(1.0, 0.0, 0.0)};
    struct d3 in = d3_unit(march(ray, 1.0, SVG_ORANGE)), bent, left;
    line(ray.origin, in, ray_pen);
    glass_refract(ray.direction, in, 1.0 / index, &bent);
    line(in, d3_add(in, d3_times(0.9, glass_reflect(ray.direction, in))), pale);
    line(d3_times(0.15, in), d3_times(1.6, in), normal_pen);
    struct mirror_ray inside = {d3_times(0.98, in), bent};
    struct d3 out = d3_unit(march(inside, -1.0, SVG_BLUE));
    line(in, out, ray_pen);
    glass_refract(bent, d3_times(-1.0, out), index, &left);
    line(out, d3_add(out, d3_times(0.75, left)), ray_pen);
    line(out, d3_add(out, d3_times(0.6, glass_reflect(bent, out))), pale);
    line(d3_times(0.45, out), d3_times(1.6, out), normal_pen);
    svg_text(40.0, 350.0, 'l', 15.0, SVG_ORANGE, "outside: steps of the distance");
    svg_text(736.0, 350.0, 'r', 15.0, SVG_BLUE, "inside: steps of minus the distance");
    svg_text(px(-1.06), py(1.12), 'r', 15.0, SVG_INK, "normal");
    angle(in, degrees(in), 180.0, 0.42, "<tspan font-style='italic'>i</tspan>");
    angle(in, degrees(d3_times(-1.0, in)), degrees(bent), 0.62,
          "<tspan font-style='italic'>j</tspan>");
    svg_end();
    return 0;
}
