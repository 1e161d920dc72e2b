// folding.c - folding in the plane: the Sierpinski triangle of level m drawn by asking one triangle
// at folded points, m = 0 to 3; 2 m reflections for 3^m copies.
#include <math.h>
#include <stdbool.h>

#include "svg.h"

// The triangle with corners (0, 1), (-a, -1/2), (a, -1/2), a = sqrt(3) / 2: inside, seen from the
// origin, is where dot(p, n) < 1/2 for its three normals.
static bool in_triangle(double x, double y)
{
    const double a = sqrt(0.75);
    return -y < 0.5 && a * x + 0.5 * y < 0.5 && -a * x + 0.5 * y < 0.5;
}

// Reflect to the side of the line through the origin where <p, (nx, ny)> >= 0.
static void fold(double *x, double *y, double nx, double ny)
{
    double side = *x * nx + *y * ny;
    if (side < 0.0) {
        *x -= 2.0 * side * nx;
        *y -= 2.0 * side * ny;
    }
}

// Two folds bring every corner to the upper one; then the copy there is centred and doubled.
static bool in_level(double x, double y, int level)
{
    const double a = sqrt(0.75);
    for (int i = 0; i < level; i++) {
        fold(&x, &y, 0.5, a);
        fold(&x, &y, -0.5, a);
        x = 2.0 * x;
        y = 2.0 * (y - 0.5);
    }
    return in_triangle(x, y);
}

// One level: the triangles whose centre in_level accepts, on a grid of 8 a side.
static void draw_level(int level, double left)
{
    const double a = sqrt(0.75), unit = 96.0, top = 70.0;
    const int n = 8;
    double side = 2.0 * a / n, rise = 1.5 / n;
    for (int row = 0; row < n; row++)
        for (int i = 0; i < 2 * row + 1; i++) {
            bool down = i % 2 == 1;
            double x = (i - row) * 0.5 * side, y = 1.0 - row * rise; // the row's upper edge
            double cy = y - (down ? 1.0 : 2.0) / 3.0 * rise, flat = down ? y : y - rise;
            if (!in_level(x, cy, level))
                continue;
            double apex = down ? y - rise : y;
            const double page[3][2] = {{left + unit * x, top + unit * (1.0 - apex)},
                                       {left + unit * (x + 0.5 * side), top + unit * (1.0 - flat)},
                                       {left + unit * (x - 0.5 * side), top + unit * (1.0 - flat)}};
            svg_polygon(3, page,
                        (struct svg_pen){.fill = SVG_BLUE, .stroke = SVG_BLUE, .width = 0.6});
        }
    svg_textf(left, 246.0, 'm', 16.0, SVG_INK, "<tspan font-style='italic'>m</tspan> = %d", level);
    static const int copies[4] = {1, 3, 9, 27};
    svg_textf(left, 268.0, 'm', 14.0, SVG_INK, "%d folds, %d %s", 2 * level, copies[level],
              level == 0 ? "triangle" : "triangles");
}

int main(void)
{
    svg_begin(
        760.0, 300.0, "Folding in the plane",
        "Four triangles side by side. The first is whole; in each next one every triangle has lost "
        "its middle quarter: 1, 3, 9 and 27 triangles, drawn with 0, 2, 4 and 6 reflections of the "
        "point that asks.");
    svg_text(24.0, 36.0, 'l', 16.0, SVG_INK, "One triangle, asked at folded points");
    for (int level = 0; level < 4; level++)
        draw_level(level, 108.0 + 181.0 * level);
    svg_end();
    return 0;
}
