// air_layers.c - how much air a ray passes: through flat layers 1 / sin h times as much as straight
// up, through a round shell never more than the level ray.
#include <math.h>

#include "svg.h"

static const double radians = 3.14159265358979323846 / 180.0;
static const struct svg_pen dashes = {.stroke = SVG_INK, .width = 1.0, .dash = "4 4"};

enum { LAYERS = 6 };

static void draw_flat(void)
{
    const double ground = 240.0, thick = 26.0, left = 30.0, right = 372.0, eye = 70.0;
    for (int i = 0; i < LAYERS; i++) {
        double top = ground - thick * (i + 1);
        const double corner[4][2] = {
            {left, top}, {right, top}, {right, top + thick}, {left, top + thick}};
        svg_polygon(4, corner, (struct svg_pen){.fill = SVG_SKY, .opacity = 1.0 - 0.155 * i});
    }
    double top = ground - thick * LAYERS, slant = 1.0 / tan(30.0 * radians);
    svg_line(left, ground, right, ground, (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    svg_arrow(eye, top - 30.0, eye, ground, (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0});
    svg_arrow(eye + slant * (ground - top + 14.0), top - 14.0, eye, ground,
              (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0});
    // What both pass of the third layer.
    double low = ground - 2.0 * thick, high = low - thick;
    svg_line(eye, low, eye, high, (struct svg_pen){.stroke = SVG_BLUE, .width = 6.0});
    svg_line(eye + slant * (ground - low), low, eye + slant * (ground - high), high,
             (struct svg_pen){.stroke = SVG_ORANGE, .width = 6.0});
    svg_text(eye + 10.0, 0.5 * (low + high) + 5.0, 'l', 15.0, SVG_BLUE, "dy");
    svg_text(eye + slant * (ground - low) + 34.0, low + 1.0, 'l', 15.0, SVG_ORANGE, "dy / sin h");
    svg_text(eye + 46.0, ground - 7.0, 'l', 15.0, SVG_INK, "h = 30&#176;");
    svg_text(eye + 8.0, top - 14.0, 'l', 15.0, SVG_BLUE, "air mass 1");
    svg_text(right - 12.0, top - 22.0, 'r', 15.0, SVG_ORANGE, "air mass 2");
    svg_text(0.5 * (left + right), ground + 32.0, 'm', 15.0, SVG_INK,
             "flat: every layer in the same ratio");
}

// The shell is drawn with 5 of its thicknesses as radius of the Earth.
static const double unit = 66.0, earth = 5.0, middle[2] = {470.0, 522.0};

static double way(double height)
{
    double climb = earth * sin(height * radians);
    return sqrt(climb * climb + 2.0 * earth + 1.0) - climb;
}

static void arc(double radius, struct svg_pen pen)
{
    double point[80][2];
    for (int i = 0; i < 80; i++) {
        double angle = (-12.0 + 57.0 * i / 79.0) * radians;
        point[i][0] = middle[0] + unit * radius * sin(angle);
        point[i][1] = middle[1] - unit * radius * cos(angle);
    }
    svg_path(80, (const double(*)[2])point, pen);
}

static void ray(double height, const char *colour)
{
    double x = middle[0], y = middle[1] - unit * earth, m = unit * way(height);
    svg_arrow(x + m * cos(height * radians), y - m * sin(height * radians), x, y,
              (struct svg_pen){.stroke = colour, .width = 2.0});
}

static void draw_round(void)
{
    double point[160][2];
    for (int i = 0; i < 160; i++) {
        double angle = (-12.0 + 57.0 * (i < 80 ? i : 159 - i) / 79.0) * radians;
        double radius = unit * (i < 80 ? earth : earth + 1.0);
        point[i][0] = middle[0] + radius * sin(angle);
        point[i][1] = middle[1] - radius * cos(angle);
    }
    svg_polygon(160, (const double(*)[2])point, (struct svg_pen){.fill = SVG_SKY});
    arc(earth, (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    arc(earth + 1.0, (struct svg_pen){.stroke = SVG_PALE, .width = 1.0});
    ray(90.0, SVG_BLUE);
    ray(30.0, SVG_ORANGE);
    ray(0.0, SVG_TEAL);
    double y = middle[1] - unit * earth, m = unit * way(0.0);
    svg_line(middle[0], y, middle[0], y + 92.0, dashes);
    double share = 92.0 / (unit * earth);
    svg_line(middle[0] + m, y, middle[0] + m - 0.52 * m, y + 0.52 * unit * earth, dashes);
    svg_text(middle[0] - 8.0, y + 70.0, 'r', 15.0, SVG_INK, "E");
    svg_text(middle[0] + m - (share + 0.14) * m + 12.0, y + (share + 0.14) * unit * earth, 'l',
             15.0, SVG_INK, "E + 1");
    svg_text(middle[0] - 10.0, y - unit - 10.0, 'm', 15.0, SVG_BLUE, "1");
    svg_textf(middle[0] + unit * way(30.0) * cos(30.0 * radians) + 8.0,
              y - 0.5 * unit * way(30.0) - 6.0, 'l', 15.0, SVG_ORANGE, "%.2f at 30&#176;",
              way(30.0));
    svg_textf(middle[0] + m + 8.0, y - 6.0, 'l', 15.0, SVG_TEAL, "%.2f", way(0.0));
    svg_text(600.0, 62.0, 'm', 15.0, SVG_INK, "round: bounded (drawn with E = 5)");
}

int main(void)
{
    svg_begin(
        760.0, 300.0, "Rays through flat layers and through a round shell",
        "Left: over flat ground six layers of air, thinner with height. A ray straight down "
        "passes a layer on the way dy, a ray at the height of 30 degrees on the way dy over "
        "sin h, twice as much. Right: a shell of air round the Earth. The level ray leaves the "
        "shell after 3.32 thicknesses, the ray at 30 degrees after 1.65. A triangle with the "
        "Earth's middle has the sides E, E plus 1 and the way of the ray.");
    draw_flat();
    draw_round();
    svg_end();
    return 0;
}
