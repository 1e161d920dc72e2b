// wrong_volumes.c - four formulas from section 2 of the report, as printed and corrected: a scaled
// ball, the inverse of a rotation, repetition, and symmetry.
#include <math.h>
#include <stdio.h>

#include "lib/matrix.h"
#include "svg.h"

static const struct svg_pen wrong = {.stroke = SVG_ORANGE, .width = 2.2};
static const struct svg_pen right = {.stroke = SVG_BLUE, .width = 2.2};
static const struct svg_pen faint = {.stroke = SVG_INK, .width = 1.0, .dash = "4 4"};

// ---- 2.2: a ball of radius 1, shrunk to half its size ----

static double ball_wrong(double x, double y)
{
    return hypot(x / 0.5, y / 0.5) - 1.0;
}

static double ball_right(double x, double y)
{
    return 0.5 * ball_wrong(x, y);
}

// Draw a march from the left along y = 0.4. Each step has a circle whose radius is the distance,
// unless the circle would be too large for the plot.
static void march(const struct svg_plot *plot, double (*f)(double, double), struct svg_pen pen)
{
    double x = -1.4, unit = plot->width / (plot->x[1] - plot->x[0]);
    double y = svg_plot_y(plot, 0.4);
    svg_line(plot->left, y, plot->left + plot->width, y,
             (struct svg_pen){.stroke = SVG_PALE, .width = 1.0});
    for (int i = 0; i < 12 && x < 3.0 && f(x, 0.4) > 0.01; i++) {
        double step = f(x, 0.4);
        svg_circle(svg_plot_x(plot, x), y, 3.0, (struct svg_pen){.fill = pen.stroke});
        if (step * unit < 64.0)
            svg_circle(svg_plot_x(plot, x), y, step * unit,
                       (struct svg_pen){.stroke = pen.stroke, .width = 1.2});
        x += step;
    }
    if (x < plot->x[1])
        svg_circle(svg_plot_x(plot, x), y, 3.0, (struct svg_pen){.fill = pen.stroke});
}

static void scaled(double top)
{
    struct svg_plot plot[2];
    const char *const words[4] = {
        "report: SDF(p / k)", "Twice the distance: the ray steps over the ball.",
        "correct: k SDF(p / k)", "Every circle is empty: the ray reaches the ball."};
    svg_pair(top, "2.2 &#160; A ball shrunk to half its size", words, (double[]){-4.3, 6.0},
             (double[]){-1.57, 2.37}, plot);
    for (int i = 0; i < 2; i++) {
        double (*f)(double, double) = i == 0 ? ball_wrong : ball_right;
        svg_circle(svg_plot_x(&plot[i], 0.0), svg_plot_y(&plot[i], 0.0), 0.5 * 340.0 / 10.3,
                   (struct svg_pen){.fill = SVG_SKY});
        svg_plot_zero(&plot[i], f, (struct svg_pen){.stroke = SVG_INK, .width = 1.5});
        march(&plot[i], f, i == 0 ? wrong : right);
    }
}

// ---- 2.2.2: a block, rotated and rotated back ----

static void block(const struct svg_plot *plot, const struct m3 *back, const struct m3 *turn,
                  struct svg_pen pen)
{
    for (int edge = 0; edge < 12; edge++) {
        double page[2][2];
        for (int end = 0; end < 2; end++) {
            int axis = edge / 4;
            double side[3];
            side[axis] = end == 0 ? -1.0 : 1.0;
            side[(axis + 1) % 3] = edge % 2 == 0 ? -1.0 : 1.0;
            side[(axis + 2) % 3] = edge / 2 % 2 == 0 ? -1.0 : 1.0;
            struct d3 p = d3(1.5 * side[0], 0.5 * side[1], 0.9 * side[2]);
            if (turn != NULL)
                p = back != NULL ? m3_apply(back, m3_apply(turn, p))
                                 : m3_apply_transposed(turn, m3_apply(turn, p));
            page[end][0] = svg_plot_x(plot, p.x + 0.35 * p.z);
            page[end][1] = svg_plot_y(plot, p.y + 0.25 * p.z);
        }
        svg_path(2, (const double(*)[2])page, pen);
    }
}

// The angle, in degrees, that remains when one rotation is undone with another. The trace of their
// product is 1 + 2 cos(angle).
//   degree  one degree, in radians
static double left_over(const struct m3 *back, const struct m3 *turn, double degree)
{
    double trace = m3_apply(back, turn->column[0]).x + m3_apply(back, turn->column[1]).y +
                   m3_apply(back, turn->column[2]).z;
    return acos(0.5 * (trace - 1.0)) / degree;
}

static void turned(double top)
{
    struct svg_plot plot[2];
    const double degree = atan(1.0) / 45.0;
    struct m3 turn = m3_rotation(30.0 * degree, 40.0 * degree, 20.0 * degree);
    struct m3 back = m3_rotation(-30.0 * degree, -40.0 * degree, -20.0 * degree);
    char askew[96];
    snprintf(askew, sizeof askew, "Turned and turned back, the block is %.1f&#176; off.",
             left_over(&back, &turn, degree));
    const char *const words[4] = {"report: R(&#8722;30&#176;, &#8722;40&#176;, &#8722;20&#176;)",
                                  askew, "correct: the transposed matrix",
                                  "The block is back in its old position (dashed)."};
    svg_pair(top, "2.2.2 &#160; The inverse of the rotation R(30&#176;, 40&#176;, 20&#176;)", words,
             (double[]){-4.25, 4.25}, (double[]){-1.625, 1.625}, plot);
    block(&plot[0], &back, &turn, wrong);
    block(&plot[1], NULL, &turn,
          (struct svg_pen){.stroke = SVG_BLUE, .width = 2.6, .opacity = 0.6});
    for (int i = 0; i < 2; i++)
        block(&plot[i], NULL, NULL, faint);
}

// ---- 2.2.3: a ball of radius 0.6 in every cell of width 2 ----

static double modulo(double x, double period)
{
    return x - period * floor(x / period);
}

static double row_wrong(double x, double y)
{
    return hypot(modulo(x - 1.0, 2.0) + 1.0, y) - 0.6;
}

static double row_right(double x, double y)
{
    return hypot(modulo(x + 1.0, 2.0) - 1.0, y) - 0.6;
}

static void repeated(double top)
{
    struct svg_plot plot[2];
    const char *const words[4] = {
        "report: mod(p.x &#8722; N/2, N) + N/2", "The distance is at least 0.4: no ball appears.",
        "correct: mod(p.x + N/2, N) &#8722; N/2", "One ball in each cell."};
    svg_pair(top, "2.2.3 &#160; A ball of radius 0.6, repeated with period 2", words,
             (double[]){-4.25, 4.25}, (double[]){-1.625, 1.625}, plot);
    for (int i = 0; i < 2; i++) {
        for (int wall = -3; wall <= 3; wall += 2) {
            double x = svg_plot_x(&plot[i], wall);
            svg_line(x, plot[i].top, x, plot[i].top + 130.0, faint);
        }
        svg_plot_zero(&plot[i], i == 0 ? row_wrong : row_right, i == 0 ? wrong : right);
    }
}

// ---- 2.2.4: a ball and its image in the mirror, which should be at x = 0.4 ----

static double mirrored(double x, double y, double offset)
{
    double d = x + offset; // the normal is (1, 0)
    return hypot((d > 0.0 ? x : x - 2.0 * d) - 1.6, y) - 0.6;
}

static double fold_wrong(double x, double y)
{
    return mirrored(x, y, 0.4);
}

static double fold_right(double x, double y)
{
    return mirrored(x, y, -0.4);
}

static void folded(double top)
{
    struct svg_plot plot[2];
    const char *const words[4] = {
        "report: offset = 0.4, as for the plane of 2.1.2",
        "It mirrors at &#10216;p, n&#10217; = &#8722;offset, on the other side.",
        "correct: offset = &#8722;0.4", "Ball and image are equally far from the mirror."};
    svg_pair(top, "2.2.4 &#160; A ball and its image; the mirror should be at x = 0.4", words,
             (double[]){-4.25, 4.25}, (double[]){-1.625, 1.625}, plot);
    for (int i = 0; i < 2; i++) {
        double meant = svg_plot_x(&plot[i], 0.4), used = svg_plot_x(&plot[i], i == 0 ? -0.4 : 0.4);
        svg_line(meant, plot[i].top, meant, plot[i].top + 130.0, faint);
        svg_line(used, plot[i].top, used, plot[i].top + 130.0,
                 (struct svg_pen){.stroke = SVG_INK, .width = 1.6});
        svg_plot_zero(&plot[i], i == 0 ? fold_wrong : fold_right, i == 0 ? wrong : right);
    }
}

int main(void)
{
    svg_begin(
        760.0, 4.0 * SVG_PAIR_ROW + 8.0, "Four formulas of section 2, as printed and corrected",
        "Four rows, each with the report's formula on the left and the correct formula on the "
        "right. A shrunk ball: the report's steps pass over it; the correct steps stop at it. A "
        "block turned and turned back: it is askew on the left, and in its old position on the "
        "right. A repeated ball: there is no ball on the left, and one in each cell on the right. "
        "A mirrored ball: with the report's sign, its image is too far to the left; with the "
        "correct sign, ball and image are equally far from the mirror.");
    scaled(8.0);
    turned(8.0 + SVG_PAIR_ROW);
    repeated(8.0 + 2.0 * SVG_PAIR_ROW);
    folded(8.0 + 3.0 * SVG_PAIR_ROW);
    svg_end();
    return 0;
}
