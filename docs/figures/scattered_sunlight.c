// scattered_sunlight.c - light that a layer of the air sends aside: the way of the sunlight down to
// it, and the way from it to the eye.
#include <math.h>
#include <stddef.h>

#include "svg.h"

static const double radians = 3.14159265358979323846 / 180.0;
static const double top = 60.0, ground = 280.0, left = 60.0, right = 690.0;

int main(void)
{
    svg_begin(
        760.0, 330.0, "Sunlight scattered once",
        "Flat air between the depth 0 at the top and tau at the ground. Sunlight comes down at a "
        "slant to a thin layer at the depth t, having passed t times s of air. There a part of "
        "it is scattered into the line of sight and passes tau minus t times v on its way to "
        "the eye.");
    for (int i = 0; i < 11; i++) {
        double y = top + 20.0 * i;
        const double corner[4][2] = {{left, y}, {right, y}, {right, y + 20.0}, {left, y + 20.0}};
        svg_polygon(4, corner, (struct svg_pen){.fill = SVG_SKY, .opacity = 0.15 + 0.08 * i});
    }
    const double p[2] = {350.0, 160.0}, sun = 20.0, view = 40.0;
    const double layer[4][2] = {{left, 154.0}, {right, 154.0}, {right, 166.0}, {left, 166.0}};
    svg_polygon(4, layer, (struct svg_pen){.fill = SVG_SAND});
    svg_line(left, top, right, top, (struct svg_pen){.stroke = SVG_PALE, .width = 1.0});
    svg_line(left, ground, right, ground, (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    double start = p[0] - (p[1] - 24.0) / tan(sun * radians);
    double end = p[0] + (ground - p[1]) / tan(view * radians);
    svg_arrow(fmax(start, 12.0), p[1] - (p[0] - fmax(start, 12.0)) * tan(sun * radians), p[0], p[1],
              (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.4});
    svg_arrow(p[0], p[1], end, ground, (struct svg_pen){.stroke = SVG_BLUE, .width = 2.4});
    svg_line(p[0] - 6.0 / tan(view * radians), 154.0, p[0] + 6.0 / tan(view * radians), 166.0,
             (struct svg_pen){.stroke = SVG_BLUE, .width = 7.0});
    svg_circle(end, ground, 5.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(right + 10.0, top + 5.0, 'l', 15.0, SVG_INK, "0");
    svg_text(right + 10.0, 165.0, 'l', 15.0, SVG_INK, "t");
    svg_text(right + 10.0, ground + 5.0, 'l', 15.0, SVG_INK, "&#964;");
    svg_text(250.0, 98.0, 'l', 15.0, SVG_ORANGE, "sunlight: the share exp(&#8722;ts) is left");
    svg_text(p[0] + 30.0, 150.0, 'l', 15.0, SVG_INK, "scattered on the way v dt");
    svg_text(p[0] + 84.0, 208.0, 'l', 15.0, SVG_BLUE,
             "line of sight: exp(&#8722;(&#964; &#8722; t)v) arrives");
    svg_text(end, ground + 26.0, 'm', 15.0, SVG_INK, "eye");
    svg_text(left + 44.0, 40.0, 'l', 15.0, SVG_INK, "space");
    svg_end();
    return 0;
}
