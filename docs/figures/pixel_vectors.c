// pixel_vectors.c - the report's figure 2: from the position of a pixel on the screen to its ray.
#include <stdio.h>

#include "svg.h"

struct point {
    double x, y, z; // right, up and forward, in screen units
};

// The eye and its screen are seen from the side and above, in a parallel projection.
static const double origin_x = 150.0, origin_y = 262.0, unit = 108.0;

static double page_x(struct point p)
{
    return origin_x + unit * (1.35 * p.z + 0.45 * p.x);
}

static double page_y(struct point p)
{
    return origin_y - unit * (p.y - 0.42 * p.x + 0.16 * p.z);
}

static void arrow(struct point a, struct point b, const char *colour, double width)
{
    svg_arrow(page_x(a), page_y(a), page_x(b), page_y(b),
              (struct svg_pen){.stroke = colour, .width = width});
}

static void line(struct point a, struct point b, const char *dash)
{
    svg_line(page_x(a), page_y(a), page_x(b), page_y(b),
             (struct svg_pen){.stroke = SVG_PALE, .width = 1.2, .dash = dash});
}

static void words(struct point p, double dx, double dy, const char *colour, const char *text)
{
    svg_text(page_x(p) + dx, page_y(p) + dy, 'l', 15.0, colour, text);
}

// Write words on the screen, with a background that hides the lines of the grid.
static void words_on_screen(struct point p, double dx, double dy, double width, const char *text)
{
    double l = page_x(p) + dx - 4.0, r = l + width + 8.0, b = page_y(p) + dy + 6.0, t = b - 21.0;
    svg_polygon(4, (const double[4][2]){{l, t}, {r, t}, {r, b}, {l, b}},
                (struct svg_pen){.fill = SVG_SKY});
    words(p, dx, dy, SVG_TEAL, text);
}

static const double focal = 2.0, aspect = 1.5;

static void draw_screen(void)
{
    const struct point corner[4] = {
        {-aspect, -1.0, focal}, {aspect, -1.0, focal}, {aspect, 1.0, focal}, {-aspect, 1.0, focal}};
    double page[4][2];
    for (int i = 0; i < 4; i++) {
        page[i][0] = page_x(corner[i]);
        page[i][1] = page_y(corner[i]);
    }
    svg_polygon(4, (const double(*)[2])page,
                (struct svg_pen){.stroke = SVG_BLUE, .fill = SVG_SKY, .opacity = 0.75});
    for (int i = 1; i < 9; i++) {
        double x = aspect * (-1.0 + 2.0 * i / 9.0);
        line((struct point){x, -1.0, focal}, (struct point){x, 1.0, focal}, NULL);
    }
    for (int i = 1; i < 6; i++) {
        double y = -1.0 + 2.0 * i / 6.0;
        line((struct point){-aspect, y, focal}, (struct point){aspect, y, focal}, NULL);
    }
}

int main(void)
{
    const struct point eye = {0.0, 0.0, 0.0}, middle = {0.0, 0.0, focal};
    const struct point pixel = {2.0 / 3.0, 0.5, focal}, foot = {2.0 / 3.0, 0.0, focal};
    const struct point beyond = {1.1, 0.825, 1.65 * focal};
    svg_begin(
        760.0, 430.0, "From a pixel to its ray",
        "An eye on the left has three arrows of length one: right, up and forward. The screen, a "
        "grid of pixels, is one focal length in front of the eye. The vector from the centre of "
        "the screen to a pixel is x times right plus y times up. The arrow from the eye through "
        "this pixel is the ray.");
    draw_screen();
    line(eye, middle, "6 5");
    arrow(eye, pixel, SVG_ORANGE, 2.6);
    svg_line(page_x(pixel), page_y(pixel), page_x(beyond), page_y(beyond),
             (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0, .dash = "7 5"});
    arrow(middle, foot, SVG_TEAL, 2.2);
    arrow(foot, pixel, SVG_TEAL, 2.2);
    arrow(eye, (struct point){0.0, 0.0, 1.0}, SVG_INK, 2.2);
    arrow(eye, (struct point){1.0, 0.0, 0.0}, SVG_INK, 2.2);
    arrow(eye, (struct point){0.0, 1.0, 0.0}, SVG_INK, 2.2);
    svg_circle(page_x(eye), page_y(eye), 5.0, (struct svg_pen){.fill = SVG_INK});
    words(eye, -44.0, 6.0, SVG_INK, "eye");
    words((struct point){0.0, 1.0, 0.0}, -12.0, -8.0, SVG_INK, "up");
    words((struct point){1.0, 0.0, 0.0}, -8.0, 22.0, SVG_INK, "right");
    words((struct point){0.0, 0.0, 1.0}, -78.0, 24.0, SVG_INK, "forward");
    words((struct point){0.0, 0.0, 1.25}, -52.0, 22.0, SVG_INK, "focalLength");
    words_on_screen(foot, -54.0, 26.0, 44.0, "<tspan font-style='italic'>x</tspan> right");
    words_on_screen(foot, 10.0, -22.0, 28.0, "<tspan font-style='italic'>y</tspan> up");
    words(beyond, -150.0, -16.0, SVG_ORANGE, "the ray through this pixel");
    svg_text(18.0, 404.0, 'l', 15.0, SVG_INK,
             "direction = normalize(<tspan font-style='italic'>x</tspan> right + <tspan "
             "font-style='italic'>y</tspan> up + focalLength forward)");
    svg_end();
    return 0;
}
