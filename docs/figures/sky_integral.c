// sky_integral.c - the light of the sky: on the left what is added up along a ray over a round
// Earth, on the right where the columns of the table lie.
#include <math.h>

#include "../../shaders/textures/air.h"
#include "svg.h"

static const double radians = 3.14159265358979323846 / 180.0;
static const double middle[2] = {215.0, 590.0}, earth = 400.0, top = 470.0;

static void ring(double radius, double from, double to, struct svg_pen pen)
{
    double point[60][2];
    for (int i = 0; i < 60; i++) {
        double angle = (from + (to - from) * i / 59.0) * radians;
        point[i][0] = middle[0] + radius * sin(angle);
        point[i][1] = middle[1] - radius * cos(angle);
    }
    svg_path(60, (const double(*)[2])point, pen);
}

static void shell(void)
{
    double point[120][2];
    for (int i = 0; i < 120; i++) {
        double angle = (-24.0 + 48.0 * (i < 60 ? i : 119 - i) / 59.0) * radians;
        double radius = i < 60 ? earth : top;
        point[i][0] = middle[0] + radius * sin(angle);
        point[i][1] = middle[1] - radius * cos(angle);
    }
    svg_polygon(120, (const double(*)[2])point, (struct svg_pen){.fill = SVG_SKY});
    ring(earth, -24.0, 24.0, (struct svg_pen){.stroke = SVG_INK, .width = 2.0});
    ring(top, -24.0, 24.0, (struct svg_pen){.stroke = SVG_PALE, .width = 1.0});
}

// The sun is a little below the eye's horizon, on the right: its rays come along (-cos, -sin).
static void rays(void)
{
    double eye[2] = {middle[0] - earth * sin(9.0 * radians),
                     middle[1] - earth * cos(9.0 * radians)};
    double up = 28.0 * radians, place[2] = {eye[0] + 96.0 * cos(up), eye[1] - 96.0 * sin(up)};
    double far[2] = {eye[0] + 128.0 * cos(up), eye[1] - 128.0 * sin(up)};
    double slope = 3.0 * radians;
    svg_line(eye[0], eye[1], far[0], far[1], (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0});
    svg_arrow(place[0] + 190.0 * cos(slope), place[1] + 190.0 * sin(slope), place[0], place[1],
              (struct svg_pen){.stroke = SVG_ORANGE, .width = 2.0});
    svg_arrow(place[0], place[1], eye[0] + 6.0 * cos(up), eye[1] - 6.0 * sin(up),
              (struct svg_pen){.stroke = SVG_BLUE, .width = 3.0});
    svg_circle(place[0], place[1], 4.0, (struct svg_pen){.fill = SVG_INK});
    svg_circle(eye[0], eye[1], 4.0, (struct svg_pen){.fill = SVG_INK});
    // The last ray that passes the Earth: below it is its shadow.
    double touch[2] = {middle[0] + earth * sin(slope), middle[1] - earth * cos(slope)};
    svg_line(touch[0] + 170.0 * cos(slope), touch[1] + 170.0 * sin(slope),
             touch[0] - 190.0 * cos(slope), touch[1] - 190.0 * sin(slope),
             (struct svg_pen){.stroke = SVG_PALE, .width = 1.5, .dash = "5 4"});
    svg_text(eye[0] - 8.0, eye[1] + 22.0, 'm', 15.0, SVG_INK, "eye");
    svg_text(place[0] - 6.0, place[1] - 12.0, 'm', 15.0, SVG_INK,
             "<tspan font-style='italic'>p</tspan>");
    svg_text(place[0] + 95.0, place[1] + 27.0, 'm', 15.0, SVG_ORANGE, "from the sun");
    svg_text(52.0, 203.0, 'l', 15.0, SVG_PALE, "shadow");
    svg_text(215.0, 280.0, 'm', 15.0, SVG_INK, "what p scatters, dimmed twice");
}

static void columns(void)
{
    struct svg_plot plot = {.left = 490.0,
                            .top = 40.0,
                            .width = 240.0,
                            .height = 190.0,
                            .x = {-0.4, 1.0},
                            .y = {0.0, 1.0}};
    double lowest = air_drawn_out(AIR_LOWEST_SUN, AIR_SUN_WIDTH), curve[120][2];
    svg_plot_frame(&plot, 0.2, 0.2, "sine of the sun's height", "place in the table");
    for (int i = 0; i <= 24; i++) {
        double x = lowest + (1.0 - lowest) * i / 24.0, sine = air_drawn_back(x, AIR_SUN_WIDTH);
        double at = svg_plot_x(&plot, sine), y = svg_plot_y(&plot, i / 24.0);
        svg_line(at, svg_plot_y(&plot, 0.0), at, y,
                 (struct svg_pen){.stroke = SVG_PALE, .width = 1.0});
        svg_circle(at, y, 2.5, (struct svg_pen){.fill = SVG_ORANGE});
    }
    for (int i = 0; i < 120; i++) {
        double share = i / 119.0;
        curve[i][0] = air_drawn_back(lowest + (1.0 - lowest) * share, AIR_SUN_WIDTH);
        curve[i][1] = share;
    }
    svg_plot_curve(&plot, 120, (const double(*)[2])curve,
                   (struct svg_pen){.stroke = SVG_BLUE, .width = 2.0});
    svg_text(610.0, 288.0, 'm', 15.0, SVG_INK, "each eighth column");
}

int main(void)
{
    svg_begin(760.0, 300.0, "The light of the sky, and where the columns of its table lie",
              "Left: a shell of air round the Earth. A ray leaves the eye upwards; at a place p of "
              "it light from a sun below the "
              "eye's horizon arrives, along a nearly level line above the Earth, and is scattered "
              "towards the eye. A dashed "
              "line touches the Earth: below it lies its shadow. Right: the place in the table "
              "against the sine of the "
              "sun's height, steep at 0: there the columns stand ten times as close.");
    shell();
    rays();
    columns();
    svg_end();
    return 0;
}
