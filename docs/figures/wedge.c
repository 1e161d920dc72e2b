// wedge.c - chapter 04's wheel seen from above, its mirrors every 30 degrees, and one point folded
// into the wedge between the mirrors at 0 and 30 degrees.
#include <math.h>
#include <stdio.h>

#include "svg.h"

static const double turn = 0.017453292519943295; // a degree, in radians
static const double middle[2] = {258.0, 252.0};  // of the wheel, pixels
static const double unit = 67.0;                 // pixels a scene unit
static const double ring = 2.5, reach = 3.1;     // of the wheel and of the mirrors, scene units

static double page_x(double x)
{
    return middle[0] + unit * x;
}

static double page_y(double z)
{
    return middle[1] + unit * z;
}

// The colour of a hue, on paper: encoded, and paler than the pure one.
static void hue_colour(double hue, char colour[8])
{
    static const double offset[3] = {0.0, 4.0, 2.0};
    unsigned byte[3];
    for (int i = 0; i < 3; i++) {
        double v = fmin(fmax(fabs(fmod(hue / 60.0 + offset[i], 6.0) - 3.0) - 1.0, 0.0), 1.0);
        byte[i] = (unsigned)(255.0 * (0.25 + 0.75 * pow(v, 0.6)) + 0.5);
    }
    snprintf(colour, 8, "#%02x%02x%02x", byte[0], byte[1], byte[2]);
}

static void draw_solid(int i)
{
    char colour[8];
    hue_colour(30.0 * i, colour);
    double c = cos(30.0 * i * turn), s = sin(30.0 * i * turn), x = ring * c, z = ring * s;
    const struct svg_pen pen = {.stroke = SVG_INK, .width = 1.2, .fill = colour};
    if (i % 2 == 0) {
        svg_circle(page_x(x), page_y(z), 0.4 * unit, pen);
        return;
    }
    double corner[4][2];
    for (int k = 0; k < 4; k++) {
        double out = k == 1 || k == 2 ? 0.33 : -0.33, across = k < 2 ? 0.33 : -0.33;
        corner[k][0] = page_x(x + out * c - across * s);
        corner[k][1] = page_y(z + out * s + across * c);
    }
    svg_polygon(4, (const double(*)[2])corner, pen);
}

// The two mirrors of the wedge are whole lines, the others dashed.
static void draw_mirror(int degrees)
{
    double c = cos(degrees * turn), s = sin(degrees * turn), far = reach + 0.16;
    const struct svg_pen pen = {
        .stroke = SVG_INK, .width = 1.1, .dash = degrees == 0 || degrees == 30 ? NULL : "5 4"};
    svg_line(page_x(0.0), page_y(0.0), page_x(reach * c), page_y(reach * s), pen);
    svg_textf(page_x(far * c), page_y(far * s) + 5.0, c > 0.3 ? 'l' : (c < -0.3 ? 'r' : 'm'), 13.0,
              SVG_INK, "%d°", degrees);
}

static void fold(double p[2], double nx, double nz)
{
    double side = fmin(nx * p[0] + nz * p[1], 0.0);
    p[0] -= 2.0 * side * nx;
    p[1] -= 2.0 * side * nz;
}

static void draw_point(int number, const double p[2], const char *words)
{
    double length = hypot(p[0], p[1]), away = 0.24; // the number stands a little nearer to the axis
    svg_circle(page_x(p[0]), page_y(p[1]), 5.5,
               (struct svg_pen){.fill = number == 3 ? SVG_ORANGE : SVG_INK});
    svg_textf(page_x(p[0] - away * p[0] / length), page_y(p[1] - away * p[1] / length) + 5.0, 'm',
              15.0, SVG_INK, "%d", number);
    double y = 150.0 + 62.0 * number;
    svg_textf(536.0, y, 'l', 15.0, SVG_INK, "%d &#160;%s", number, words);
    svg_textf(554.0, y + 22.0, 'l', 15.0, SVG_INK, "(%.3f, %.3f), at %.1f°", p[0], p[1],
              atan2(p[1], p[0]) / turn);
}

static void draw_step(const double from[2], const double to[2])
{
    double dx = to[0] - from[0], dz = to[1] - from[1], length = hypot(dx, dz);
    double ux = 0.12 * dx / length, uz = 0.12 * dz / length;
    svg_arrow(page_x(from[0] + ux), page_y(from[1] + uz), page_x(to[0] - ux), page_y(to[1] - uz),
              (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.2});
}

int main(void)
{
    svg_begin(760.0, 510.0, "Twelve solids, one wedge",
              "The wheel from above: six balls and six dice in turn, every 30 degrees, each on a "
              "mirror. The wedge between the mirrors at 0 and 30 degrees is shaded; the ball's "
              "half and the die's half are in it. A point at 110.2 degrees is folded at the "
              "mirror of 90 degrees to 69.8, at that of 60 to 50.2, at that of 30 to 9.8.");
    double wedge[32][2] = {{page_x(0.0), page_y(0.0)}};
    for (int i = 0; i < 31; i++) {
        wedge[i + 1][0] = page_x(reach * cos(i * turn));
        wedge[i + 1][1] = page_y(reach * sin(i * turn));
    }
    svg_polygon(32, (const double(*)[2])wedge, (struct svg_pen){.fill = SVG_SAND});
    for (int i = 0; i < 12; i++)
        draw_solid(i);
    for (int i = 0; i < 12; i++)
        draw_mirror(30 * i);
    const double root = sqrt(0.75);
    double p[4][2] = {{-0.7, 1.9}, {0.7, 1.9}};
    for (int i = 2; i < 4; i++)
        p[i][0] = p[i - 1][0], p[i][1] = p[i - 1][1];
    fold(p[2], root, -0.5);
    p[3][0] = p[2][0], p[3][1] = p[2][1];
    fold(p[3], 0.5, -root);
    for (int i = 0; i < 3; i++)
        draw_step(p[i], p[i + 1]);
    static const char *const words[4] = {"the point (x, z)", "abs: the mirrors at 0°, 90°",
                                         "folded at the mirror of 60°",
                                         "folded at the mirror of 30°"};
    for (int i = 0; i < 4; i++)
        draw_point(i, p[i], words[i]);
    svg_text(536.0, 52.0, 'l', 16.0, SVG_INK, "The wheel from above:");
    svg_text(536.0, 74.0, 'l', 16.0, SVG_INK, "x to the right, z towards you");
    svg_end();
    return 0;
}
