// penumbra.c - a lamp with a size, an edge and a floor: umbra, penumbra and light, and what three
// points see of the lamp.
#include <math.h>

#include "svg.h"

static const double floor_y = 330.0, lamp_y = 40.0, edge_y = 190.0;
static const double lamp_x = 250.0, lamp_radius = 46.0, edge_x = 250.0;

// Where the ray from a place on the lamp past the edge meets the floor.
static double floor_x(double from)
{
    double share = (floor_y - lamp_y) / (edge_y - lamp_y);
    return from + share * (edge_x - from);
}

// The disc as a point sees it, with what the edge hides in blue.
//   clear  from -1 to 1
static void disc(double x, double y, double clear, const char *name, const char *words)
{
    enum { POINTS = 60 };
    const double radius = 42.0;
    double hidden[POINTS][2], angle = acos(clear);
    svg_circle(x, y, radius,
               (struct svg_pen){.stroke = SVG_ORANGE, .fill = SVG_SAND, .width = 2.0});
    // From the left the edge hides all up to the chord, which stands at -clear.
    for (int i = 0; i < POINTS; i++) {
        double turn = (2.0 * i / (POINTS - 1.0) - 1.0) * angle;
        hidden[i][0] = x - radius * cos(turn);
        hidden[i][1] = y + radius * sin(turn);
    }
    svg_polygon(POINTS, (const double(*)[2])hidden,
                (struct svg_pen){.stroke = SVG_BLUE, .fill = SVG_SKY, .width = 2.0});
    svg_text(x, y + 66.0, 'm', 15.0, SVG_INK, name);
    svg_text(x, y + 86.0, 'm', 14.0, SVG_INK, words);
}

int main(void)
{
    double dark = floor_x(lamp_x - lamp_radius), light = floor_x(lamp_x + lamp_radius);
    double low = fmin(dark, light), high = fmax(dark, light), middle = floor_x(lamp_x);
    svg_begin(
        760.0, 440.0, "What is seen of a lamp past an edge",
        "Left a round lamp over a plate whose edge stands under its middle, and a floor. On the "
        "floor the umbra lies on the left, the lit part on the right, the penumbra between "
        "two rays that cross at the edge. Right the lamp's disc as three points of the "
        "floor see it: a tenth, a half and nine tenths of it are beside the edge.");
    const double part[4][2] = {{edge_x, edge_y}, {low, floor_y}, {high, floor_y}, {edge_x, edge_y}};
    svg_polygon(4, part, (struct svg_pen){.fill = SVG_SKY, .opacity = 0.6});
    svg_line(lamp_x - lamp_radius, lamp_y, lamp_x + lamp_radius, lamp_y,
             (struct svg_pen){.stroke = SVG_ORANGE, .width = 7.0});
    svg_line(lamp_x - lamp_radius, lamp_y, floor_x(lamp_x - lamp_radius), floor_y,
             (struct svg_pen){.stroke = SVG_ORANGE, .width = 1.4});
    svg_line(lamp_x + lamp_radius, lamp_y, floor_x(lamp_x + lamp_radius), floor_y,
             (struct svg_pen){.stroke = SVG_ORANGE, .width = 1.4});
    svg_line(60.0, edge_y, edge_x, edge_y, (struct svg_pen){.stroke = SVG_BLUE, .width = 6.0});
    svg_line(30.0, floor_y, 440.0, floor_y, (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    svg_text(lamp_x, lamp_y - 14.0, 'm', 15.0, SVG_INK, "lamp");
    svg_text(120.0, edge_y - 12.0, 'm', 15.0, SVG_INK, "plate");
    svg_text(0.5 * (30.0 + low), floor_y + 26.0, 'm', 15.0, SVG_INK, "umbra");
    svg_text(0.5 * (440.0 + high) + 6.0, floor_y + 26.0, 'm', 15.0, SVG_INK, "lit");
    svg_arrow(middle, floor_y + 12.0, low, floor_y + 12.0, (struct svg_pen){.stroke = SVG_BLUE});
    svg_arrow(middle, floor_y + 12.0, high, floor_y + 12.0, (struct svg_pen){.stroke = SVG_BLUE});
    svg_text(middle, floor_y + 34.0, 'm', 15.0, SVG_BLUE, "penumbra");
    double half = 0.5 * (high - low);
    const double clear[3] = {-0.687, 0.0, 0.687}; // a tenth is seen, a half, nine tenths
    const char *const names[3] = {"P", "Q", "R"};
    const char *const words[3] = {"sees a tenth", "sees a half", "sees nine tenths"};
    for (int i = 0; i < 3; i++) {
        double x = middle + half * clear[i];
        svg_circle(x, floor_y, 4.0, (struct svg_pen){.fill = SVG_INK});
        svg_text(x, floor_y - 10.0, 'm', 14.0, SVG_INK, names[i]);
        disc(640.0, 62.0 + 138.0 * i, clear[i], names[i], words[i]);
    }
    svg_end();
    return 0;
}
