// tetrahedron_regions.c - a cut through a tetrahedron, along one of its edges and through the
// middle of the opposite one: what of it is nearest, and the lines of equal distance, exact and by
// planes.
#include <math.h>
#include <stdbool.h>

#include "svg.h"

// The cut holds the corners (1, 1, 1) and (-1, -1, 1), at (sqrt(2), 1) and (-sqrt(2), 1), and the
// middle of the edge between the others at (0, -1). A place (u, v) of it is the point
// (u / sqrt(2), u / sqrt(2), v).
#define CORNER 1.4142136

// The largest of the signed distances to the four planes, as sdTetrahedronPlanes has it.
static double by_planes(double u, double v)
{
    double sum = CORNER * fabs(u); // |x + y|; x - y is 0 here
    return (fmax(sum - v, v) - 1.0) / sqrt(3.0);
}

// The nearest point of a triangle that is its own image in the cut lies in the cut: in two
// dimensions, the distance to three segments.
static double segment(double u, double v, double u0, double v0, double u1, double v1)
{
    double along = ((u - u0) * (u1 - u0) + (v - v0) * (v1 - v0)) /
                   ((u1 - u0) * (u1 - u0) + (v1 - v0) * (v1 - v0));
    along = fmin(fmax(along, 0.0), 1.0);
    return hypot(u - u0 - along * (u1 - u0), v - v0 - along * (v1 - v0));
}

static double exact(double u, double v)
{
    if (by_planes(u, v) <= 0.0)
        return by_planes(u, v);
    double side =
        fmin(segment(u, v, 0.0, -1.0, CORNER, 1.0), segment(u, v, 0.0, -1.0, -CORNER, 1.0));
    return fmin(side, segment(u, v, -CORNER, 1.0, CORNER, 1.0));
}

static double level; // whose line is drawn

static double exact_line(double u, double v)
{
    return exact(u, v) - level;
}

static void fill(const struct svg_plot *plot, int count, const double (*place)[2],
                 const char *colour)
{
    double page[6][2];
    for (int k = 0; k < count; k++) {
        page[k][0] = svg_plot_x(plot, place[k][0]);
        page[k][1] = svg_plot_y(plot, place[k][1]);
    }
    svg_polygon(count, (const double(*)[2])page, (struct svg_pen){.fill = colour});
}

// Where the line from (u, v) along (du, dv) leaves the plot's upper or lower edge, or a side.
static void leave(const struct svg_plot *plot, double u, double v, double du, double dv,
                  double place[2])
{
    double across = ((du > 0.0 ? plot->x[1] : plot->x[0]) - u) / du;
    double up = dv == 0.0 ? HUGE_VAL : ((dv > 0.0 ? plot->y[1] : plot->y[0]) - v) / dv;
    double t = fmin(across, up);
    place[0] = u + t * du;
    place[1] = v + t * dv;
}

// The right half and its mirror image. The face's normal in the cut is (sqrt(2), -1) / sqrt(3).
static void draw_regions(const struct svg_plot *plot)
{
    for (int side = -1; side <= 1; side += 2) {
        double low[2], high[2], s = side;
        leave(plot, 0.0, -1.0, s * CORNER, -1.0, low);
        leave(plot, s * CORNER, 1.0, s * CORNER, -1.0, high);
        const double face[5][2] = {{0.0, -1.0},
                                   {low[0], low[1]},
                                   {s * plot->x[1], plot->y[0]},
                                   {high[0], high[1]},
                                   {s * CORNER, 1.0}};
        const double corner[4][2] = {{s * CORNER, 1.0},
                                     {high[0], high[1]},
                                     {s * plot->x[1], plot->y[1]},
                                     {s * CORNER, plot->y[1]}};
        const double edge[3][2] = {{0.0, -1.0}, {low[0], low[1]}, {0.0, plot->y[0]}};
        fill(plot, 5, face, SVG_SKY);
        fill(plot, 4, corner, "#f0c9a8");
        fill(plot, 3, edge, SVG_SAND);
    }
    const double over[4][2] = {
        {-CORNER, 1.0}, {CORNER, 1.0}, {CORNER, plot->y[1]}, {-CORNER, plot->y[1]}};
    fill(plot, 4, over, SVG_SAND);
}

static void draw_solid(const struct svg_plot *plot)
{
    const double solid[3][2] = {{0.0, -1.0}, {CORNER, 1.0}, {-CORNER, 1.0}};
    fill(plot, 3, solid, SVG_BLUE);
}

// Where by_planes has the value f: the three sides, each moved out by f sqrt(3).
static void draw_planes_line(const struct svg_plot *plot, double f)
{
    double out = f * sqrt(3.0), u = CORNER * (1.0 + out);
    const double page[3][2] = {{svg_plot_x(plot, 0.0), svg_plot_y(plot, -1.0 - out)},
                               {svg_plot_x(plot, u), svg_plot_y(plot, 1.0 + out)},
                               {svg_plot_x(plot, -u), svg_plot_y(plot, 1.0 + out)}};
    svg_polygon(3, page, (struct svg_pen){.stroke = SVG_INK, .width = 1.1});
}

static void label(const struct svg_plot *plot, double u, double v, const char *words)
{
    svg_text(svg_plot_x(plot, u), svg_plot_y(plot, v), 'm', 14.0, SVG_INK, words);
}

int main(void)
{
    const struct svg_plot left = {24.0,        56.0,          344.0, 265.17,
                                  {-2.4, 2.4}, {-1.95, 1.75}, false, false};
    struct svg_plot right = left;
    right.left = 392.0;
    svg_begin(
        760.0, 392.0, "What of a tetrahedron is nearest",
        "Two copies of a cut through a tetrahedron. Left the regions outside it in which a "
        "face, an edge or a corner is nearest, with the lines of equal exact distance, straight "
        "before faces and edges, round before corners. Right the lines of the distance by "
        "planes: all straight, with sharp corners that reach three times as far.");
    svg_text(24.0, 36.0, 'l', 16.0, SVG_INK, "Nearest is a face, an edge or a corner");
    draw_regions(&left);
    for (int k = 1; k <= 2; k++) {
        level = 0.2 * k;
        svg_plot_zero(&left, exact_line, (struct svg_pen){.stroke = SVG_INK, .width = 1.1});
        draw_planes_line(&right, level);
    }
    draw_solid(&left);
    draw_solid(&right);
    label(&left, 0.0, 1.53, "an edge");
    label(&left, 0.0, -1.78, "an edge");
    label(&left, -1.75, -0.9, "a face");
    label(&left, 1.75, -0.9, "a face");
    label(&left, -2.02, 1.55, "a corner");
    label(&left, 2.02, 1.55, "a corner");
    label(&right, 0.0, 1.47, "0.58 d");
    label(&right, 0.0, -1.88, "0.58 d");
    label(&right, -1.75, -0.9, "d");
    label(&right, 1.75, -0.9, "d");
    label(&right, -2.15, 0.75, "d / 3");
    label(&right, 2.15, 0.75, "d / 3");
    svg_text(196.0, 344.0, 'm', 15.0, SVG_INK, "exact: what is nearest");
    svg_text(196.0, 366.0, 'm', 14.0, SVG_INK, "lines of d = 0.2 and 0.4");
    svg_text(564.0, 344.0, 'm', 15.0, SVG_INK, "by planes: at least so much");
    svg_text(564.0, 366.0, 'm', 14.0, SVG_INK, "lines of f = 0.2 and 0.4");
    svg_end();
    return 0;
}
