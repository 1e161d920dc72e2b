// celestial_sphere.c - the sun's path over Toulouse on a day in December, March and June: circles
// around the celestial pole, computed with the formula of sunDirection in shaders/sky.glsl.
#include <math.h>
#include <stddef.h>

#include "svg.h"

static const double radians = 3.14159265358979323846 / 180.0, latitude = 43.6;

// The sphere is seen from the west, slightly from the south and from above. The axes are x north,
// y up and z east. The angles are in degrees.
static const double view_east = 62.0, view_high = 20.0, size = 165.0, middle[2] = {270.0, 195.0};

static void page(const double p[3], double out[3])
{
    double a = view_east * radians, b = view_high * radians;
    double to_eye[3] = {-cos(b) * cos(a), sin(b), -cos(b) * sin(a)};
    double right[3] = {-sin(a), 0.0, cos(a)};
    double up[3] = {sin(b) * cos(a), cos(b), sin(b) * sin(a)};
    out[0] = middle[0] + size * (p[0] * right[0] + p[1] * right[1] + p[2] * right[2]);
    out[1] = middle[1] - size * (p[0] * up[0] + p[1] * up[1] + p[2] * up[2]);
    out[2] = p[0] * to_eye[0] + p[1] * to_eye[1] + p[2] * to_eye[2];
}

static void sun_at(double declination, double hour_angle, double out[3])
{
    double p = latitude * radians, d = declination * radians, h = hour_angle * radians;
    out[0] = cos(p) * sin(d) - sin(p) * cos(d) * cos(h);
    out[1] = sin(p) * sin(d) + cos(p) * cos(d) * cos(h);
    out[2] = -cos(d) * sin(h);
}

static void piece(const double a[3], const double b[3], struct svg_pen pen)
{
    double from[3], to[3];
    page(a, from);
    page(b, to);
    svg_line(from[0], from[1], to[0], to[1], pen);
}

static void day(double declination, const char *name)
{
    for (int i = -60; i < 60; i++) {
        double a[3], b[3];
        sun_at(declination, 3.0 * i, a);
        sun_at(declination, 3.0 * i + 3.0, b);
        struct svg_pen pen = {.stroke = SVG_ORANGE, .width = 2.2};
        if (a[1] + b[1] < 0.0)
            pen = (struct svg_pen){.stroke = SVG_PALE, .width = 1.0};
        piece(a, b, pen);
    }
    // The name is written to the right of the circle's rightmost point.
    double noon[3], at[3], right = 0.0;
    for (int i = 0; i < 90; i++) {
        sun_at(declination, -i, noon);
        page(noon, at);
        right = fmax(right, at[0]);
    }
    sun_at(declination, 0.0, noon);
    page(noon, at);
    svg_text(right + 10.0, at[1] - 4.0, 'l', 14.0, SVG_ORANGE, name);
}

static void mark(const double p[3], double dx, double dy, const char *colour, const char *name)
{
    double at[3];
    page(p, at);
    svg_circle(at[0], at[1], 3.5, (struct svg_pen){.fill = colour});
    svg_text(at[0] + dx, at[1] + dy, 'm', 15.0, colour, name);
}

static void vector(const double p[3], const char *colour, double dx, double dy, const char *name)
{
    double to[3];
    page(p, to);
    svg_arrow(middle[0], middle[1], to[0], to[1], (struct svg_pen){.stroke = colour, .width = 2.0});
    svg_text(to[0] + dx, to[1] + dy, 'm', 16.0, colour, name);
}

static void horizon(void)
{
    double rim[72][2];
    for (int i = 0; i < 72; i++) {
        double at[3], p[3] = {cos(5.0 * i * radians), 0.0, sin(5.0 * i * radians)};
        page(p, at);
        rim[i][0] = at[0];
        rim[i][1] = at[1];
    }
    svg_polygon(
        72, (const double(*)[2])rim,
        (struct svg_pen){.fill = SVG_SKY, .stroke = SVG_BLUE, .width = 1.2, .opacity = 0.75});
}

static void words(void)
{
    const double x = 530.0;
    svg_text(x, 96.0, 'l', 15.0, SVG_BLUE, "P: the pole, at height &#966;");
    svg_text(x, 124.0, 'l', 15.0, SVG_TEAL, "M: perpendicular to P,");
    svg_text(x, 143.0, 'l', 15.0, SVG_TEAL, "due south, at height 90&#176; &#8722; &#966;");
    svg_text(x, 171.0, 'l', 15.0, SVG_INK, "W: west, on the horizon");
    svg_text(x, 199.0, 'l', 15.0, SVG_ORANGE, "S: the sun in June at 15 h,");
    svg_text(x, 218.0, 'l', 15.0, SVG_ORANGE, "H = 45&#176; after noon");
    svg_text(x, 246.0, 'l', 15.0, SVG_PALE, "pale: below the horizon");
}

int main(void)
{
    svg_begin(
        760.0, 386.0, "The path of the sun over a day",
        "A sphere with the horizon as its horizontal disc, seen from the west. The celestial pole "
        "P is 43.6 degrees above the northern horizon. The sun moves on circles around the pole: "
        "low in the south in December, from due east to due west in March, and high in June. M, "
        "which is perpendicular to P, points due south and upwards; W points west.");
    svg_circle(middle[0], middle[1], size, (struct svg_pen){.stroke = SVG_PALE, .width = 1.2});
    horizon();
    day(-23.44, "December");
    day(0.0, "March");
    day(23.44, "June");
    double p = latitude * radians, sun[3];
    const double pole[3] = {cos(p), sin(p), 0.0}, south[3] = {-sin(p), cos(p), 0.0},
                 west[3] = {0.0, 0.0, -1.0};
    sun_at(23.44, 45.0, sun);
    vector(pole, SVG_BLUE, -4.0, -10.0, "P");
    vector(south, SVG_TEAL, -10.0, -8.0, "M");
    vector(west, SVG_INK, -6.0, 22.0, "W");
    vector(sun, SVG_ORANGE, -8.0, -12.0, "S");
    mark((const double[3]){1.0, 0.0, 0.0}, 26.0, 3.0, SVG_INK, "north");
    mark((const double[3]){-1.0, 0.0, 0.0}, -26.0, 3.0, SVG_INK, "south");
    mark((const double[3]){0.0, 0.0, 1.0}, 32.0, 17.0, SVG_INK, "east");
    mark((const double[3]){0.0, 1.0, 0.0}, 0.0, 22.0, SVG_INK, "zenith");
    words();
    svg_end();
    return 0;
}
