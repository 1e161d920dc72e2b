// footprint.c - the ray of a pixel is as wide as the pixel; what it covers of a floor is longer by
// one over the sine of the angle. Left from the side, right the floor's texels from above, with the
// level whose texel is as large.
#include <math.h>

#include "svg.h"

static const double EYE[2] = {56.0, 86.0};
static const double FLOOR = 250.0;

// The ray of a pixel from the eye to the floor, at an angle: its two rims and what they cover.
static void draw_ray(double degrees, double half, const char *colour)
{
    double angle = degrees * atan(1.0) / 45.0, x[2];
    for (int i = 0; i < 2; i++) {
        double rim = angle + (i == 0 ? half : -half);
        x[i] = EYE[0] + (FLOOR - EYE[1]) / tan(rim);
        svg_line(EYE[0], EYE[1], x[i], FLOOR, (struct svg_pen){.stroke = colour, .width = 1.2});
    }
    svg_line(x[0], FLOOR + 3.0, x[1], FLOOR + 3.0,
             (struct svg_pen){.stroke = colour, .width = 6.0});
    // Its width, square to the ray, where its middle meets the floor.
    double t = (FLOOR - EYE[1]) / sin(angle), wide = t * tan(half);
    double mx = EYE[0] + t * cos(angle), my = FLOOR;
    svg_line(mx - wide * sin(angle), my + wide * cos(angle), mx + wide * sin(angle),
             my - wide * cos(angle), (struct svg_pen){.stroke = SVG_INK, .width = 1.6});
}

// Texels from above, and a footprint on them: an ellipse of two sides in texels.
static void draw_texels(double left, double top, double wide, double tall, const char *colour,
                        const char *words, const char *more)
{
    const double texel = 10.0, side = 160.0;
    for (int i = 0; i <= 16; i++) {
        const struct svg_pen thin = {.stroke = SVG_PALE, .width = i % 8 == 0 ? 1.4 : 0.5};
        svg_line(left + i * texel, top, left + i * texel, top + side, thin);
        svg_line(left, top + i * texel, left + side, top + i * texel, thin);
    }
    // The texel of the level that serves the longer side.
    double level = ceil(log2(tall)), step = exp2(level) * texel;
    double x = left + 0.5 * side - 0.5 * step, y = top + 0.5 * side - 0.5 * step;
    const double square[4][2] = {{x, y}, {x + step, y}, {x + step, y + step}, {x, y + step}};
    svg_polygon(
        4, square,
        (struct svg_pen){.fill = SVG_SAND, .stroke = SVG_ORANGE, .width = 1.6, .opacity = 0.75});
    double ellipse[64][2];
    for (int i = 0; i < 64; i++) {
        double angle = i * atan(1.0) / 8.0;
        ellipse[i][0] = left + 0.5 * side + 0.5 * wide * texel * cos(angle);
        ellipse[i][1] = top + 0.5 * side + 0.5 * tall * texel * sin(angle);
    }
    svg_polygon(64, (const double(*)[2])ellipse,
                (struct svg_pen){.fill = colour, .stroke = colour, .width = 1.6, .opacity = 0.7});
    svg_text(left + 0.5 * side, top + side + 22.0, 'm', 14.0, colour, words);
    svg_textf(left + 0.5 * side, top + side + 42.0, 'm', 14.0, SVG_INK, more, level);
}

int main(void)
{
    svg_begin(
        760.0, 330.0, "What a pixel covers of a floor",
        "On the left two rays of one pixel's width fall on a floor, one steep, one flat; the flat "
        "one covers several times as much of it, though it is hardly wider. On the right the two "
        "footprints on the texels of a picture: a small circle, for which level 1 will do, and a "
        "long "
        "ellipse, which the texel of level 3 covers along its length and far beyond its width.");
    svg_text(30.0, 36.0, 'l', 16.0, SVG_INK,
             "From the side: the ray of a pixel, and what it covers");
    svg_line(30.0, FLOOR, 390.0, FLOOR, (struct svg_pen){.stroke = SVG_INK, .width = 1.2});
    svg_circle(EYE[0], EYE[1], 4.0, (struct svg_pen){.fill = SVG_INK});
    svg_text(EYE[0] - 4.0, EYE[1] - 12.0, 'm', 14.0, SVG_INK, "eye");
    draw_ray(64.0, 0.055, SVG_BLUE);
    draw_ray(30.0, 0.055, SVG_TEAL);
    svg_text(136.0, 282.0, 'm', 14.0, SVG_BLUE, "steep: hardly longer");
    svg_text(345.0, 282.0, 'm', 14.0, SVG_TEAL, "flat: twice as long");
    svg_text(345.0, 302.0, 'm', 14.0, SVG_INK, "as the ray is wide");
    draw_texels(420.0, 66.0, 1.9, 2.0, SVG_BLUE, "2 x 2 texels", "level %.0f");
    draw_texels(592.0, 66.0, 2.4, 8.0, SVG_TEAL, "2.4 x 8 texels", "level %.0f: too wide across");
    svg_text(420.0, 36.0, 'l', 16.0, SVG_INK, "From above, with the level's texel");
    svg_end();
    return 0;
}
