// wrong_rays.c - three of the report's statements about rays, as printed and corrected: the basis
// of the eye, the end of a march, and the parallel view.
#include <math.h>

#include "lib/mirror.h"
#include "svg.h"

static const struct svg_pen faint = {.stroke = SVG_INK, .width = 1.0, .dash = "4 4"};

// SVG text: the name of a basis vector with its subscript, and the rest of the line.
#define E(letter, after)                                                                           \
    "e<tspan font-size='10' dy='3'>" letter "</tspan><tspan dx='4' dy='-3'>" after "</tspan>"

static const char *colour_of(int side)
{
    return side == 0 ? SVG_ORANGE : SVG_BLUE;
}

// ---- 1.3, from above: the eye looks along -z; a ball on the right, a box on the left ----

static void pixel_ray(const struct svg_plot *plot, double towards, const char *colour)
{
    struct d3 view = d3(0.0, 0.0, -1.0), ez = d3_times(towards, view);
    struct d3 ex = d3_unit(d3_cross(ez, d3(0.0, 1.0, 0.0)));
    const double focal_length = 1.2, x = 0.8; // the pixel is to the right of the centre
    struct d3 direction = d3_add(d3_times(x, ex), d3_times(towards * focal_length, ez));
    double ox = svg_plot_x(plot, 0.0), oy = svg_plot_y(plot, 0.0);
    svg_arrow(ox, oy, svg_plot_x(plot, 1.1 * ex.x), svg_plot_y(plot, -1.1 * ex.z),
              (struct svg_pen){.stroke = SVG_INK});
    svg_arrow(ox, oy, svg_plot_x(plot, 2.45 * direction.x), svg_plot_y(plot, -2.45 * direction.z),
              (struct svg_pen){.stroke = colour, .width = 2.2});
    svg_circle(ox, oy, 4.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(svg_plot_x(plot, 1.3 * ex.x), svg_plot_y(plot, -0.12), ex.x > 0.0 ? 'l' : 'r', 14.0,
             SVG_INK, E("x", ""));
}

static void mirrored(double top)
{
    struct svg_plot plot[2];
    const char *const words[4] = {
        "report: " E("z", "against the view; x") E("x", "+ y") E("y", "&#8722; FL") E("z", ""),
        "The ray through a pixel on the right goes to the left.",
        "correct: " E("z", "along the view; x") E("x", "+ y") E("y", "+ FL") E("z", ""),
        "The ray goes to the right."};
    svg_pair(top, "1.3 &#160; The basis of the eye, seen from above; the eye looks up the page",
             words, (double[]){-5.2, 5.2}, (double[]){-0.45, 3.527}, plot);
    for (int i = 0; i < 2; i++) {
        const struct svg_pen thing = {.stroke = SVG_INK, .fill = SVG_SKY};
        double l = svg_plot_x(&plot[i], -2.55), r = svg_plot_x(&plot[i], -1.65),
               t = svg_plot_y(&plot[i], 3.35), b = svg_plot_y(&plot[i], 2.45);
        svg_polygon(4, (const double[4][2]){{l, t}, {r, t}, {r, b}, {l, b}}, thing);
        svg_circle(svg_plot_x(&plot[i], 2.1), svg_plot_y(&plot[i], 2.9), 15.0, thing);
        double ahead = svg_plot_x(&plot[i], 0.0);
        svg_line(ahead, plot[i].top + 6.0, ahead, plot[i].top + 110.0, faint);
        pixel_ray(&plot[i], i == 0 ? -1.0 : 1.0, colour_of(i));
    }
}

// ---- 1.4: a ball of radius 3, 25 in front of the eye; a ray passes 2.5 from its centre ----

static double ball_at(double t)
{
    return hypot(t - 25.0, 2.5) - 3.0;
}

// Draw the axis of t and the curve of the distance.
static void draw_distance(const struct svg_plot *plot)
{
    double curve[240][2], base = svg_plot_y(plot, 0.0);
    for (int k = 0; k < 240; k++) {
        curve[k][0] = 23.5 * k / 239.0;
        curve[k][1] = ball_at(curve[k][0]);
    }
    svg_line(svg_plot_x(plot, 0.0), base, svg_plot_x(plot, 29.0), base,
             (struct svg_pen){.stroke = SVG_INK});
    svg_text(svg_plot_x(plot, 29.4), base - 6.0, 'r', 13.0, SVG_INK,
             "<tspan font-style='italic'>t</tspan>");
    svg_plot_curve(plot, 240, (const double(*)[2])curve,
                   (struct svg_pen){.stroke = SVG_PALE, .width = 1.6});
}

// Draw at most `most` steps of the march, each with its distance.
static void draw_steps(const struct svg_plot *plot, int most, const char *colour)
{
    double t = 0.0, base = svg_plot_y(plot, 0.0);
    for (int step = 0; step < most && ball_at(t) > 0.01; step++) {
        double x = svg_plot_x(plot, t), y = svg_plot_y(plot, ball_at(t));
        svg_line(x, base, x, y, (struct svg_pen){.stroke = colour, .width = 1.2});
        svg_circle(x, y, 3.5, (struct svg_pen){.fill = colour});
        t += ball_at(t);
    }
}

static void ended(double top)
{
    struct svg_plot plot[2];
    const char *const words[4] = {"report: a distance of 20 or more is a miss",
                                  "The first step counts as a miss: the ball is lost.",
                                  "correct: a path longer than the far limit is a miss",
                                  "The march goes on and reaches the ball."};
    svg_pair(top, "1.4 &#160; The distance along a ray to a ball that is 22 units away", words,
             (double[]){-3.0, 30.0}, (double[]){-4.0, 28.0}, plot);
    double limit = svg_plot_y(&plot[0], 20.0);
    svg_line(svg_plot_x(&plot[0], 0.0), limit, svg_plot_x(&plot[0], 29.0), limit, faint);
    svg_text(svg_plot_x(&plot[0], 28.8), limit - 6.0, 'r', 13.0, SVG_INK, "20");
    for (int i = 0; i < 2; i++) {
        draw_distance(&plot[i]);
        draw_steps(&plot[i], i == 0 ? 1 : 20, colour_of(i));
    }
}

// ---- 2.3: parallel rays towards a ball of radius 1.6, from the side ----

static void parallel(double top)
{
    struct svg_plot plot[2];
    const char *const words[4] = {"report: origin = camera + x" E("x", "+ y") E("y", ""),
                                  "The view is always two units high: the ball is cut off.",
                                  "correct: camera + sx" E("x", "+ sy") E("y", "with s = 2 here"),
                                  "The view is 2 s units high: choose s to fit."};
    svg_pair(top, "2.3 &#160; The parallel view of a ball of radius 1.6, from the side", words,
             (double[]){-6.0, 6.0}, (double[]){-2.294, 2.294}, plot);
    for (int i = 0; i < 2; i++) {
        double unit = 340.0 / 12.0, scale = i == 0 ? 1.0 : 2.0, screen = svg_plot_x(&plot[i], -4.0);
        svg_circle(svg_plot_x(&plot[i], 1.5), svg_plot_y(&plot[i], 0.0), 1.6 * unit,
                   (struct svg_pen){.stroke = SVG_INK, .fill = SVG_SKY});
        svg_line(screen, svg_plot_y(&plot[i], scale), screen, svg_plot_y(&plot[i], -scale),
                 (struct svg_pen){.stroke = SVG_INK, .width = 3.0});
        for (int k = -4; k <= 4; k++) {
            double y = scale * k / 4.0;
            double end = fabs(y) < 1.6 ? 1.5 - sqrt(1.6 * 1.6 - y * y) : 5.6;
            svg_arrow(screen, svg_plot_y(&plot[i], y), svg_plot_x(&plot[i], end),
                      svg_plot_y(&plot[i], y),
                      (struct svg_pen){.stroke = colour_of(i), .width = 1.2});
        }
    }
}

int main(void)
{
    svg_begin(
        760.0, 3.0 * SVG_PAIR_ROW + 8.0, "Three statements about rays, as printed and corrected",
        "Three rows, each with the report's statement on the left and the correct statement on the "
        "right. The basis of the eye: on the left, the ray through a pixel on the right goes to "
        "the box on the left; on the right, it goes to the ball on the right. The end of a march: "
        "on the left, the march is abandoned at its first step, whose distance exceeds 20; on the "
        "right, it goes on in ever smaller steps to the ball. The parallel view: on the left, the "
        "rays cover only the middle of the ball; on the right, they cover the whole ball.");
    mirrored(8.0);
    ended(8.0 + SVG_PAIR_ROW);
    parallel(8.0 + 2.0 * SVG_PAIR_ROW);
    svg_end();
    return 0;
}
