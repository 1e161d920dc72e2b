#include "svg.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

void svg_begin(double width, double height, const char *title, const char *description)
{
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
           "viewBox=\"0 0 %.0f %.0f\" role=\"img\" aria-labelledby=\"title description\" "
           "font-family=\"Helvetica, Arial, sans-serif\">\n",
           width, height, width, height);
    printf("<title id=\"title\">%s</title>\n<desc id=\"description\">%s</desc>\n", title,
           description);
    printf("<rect width=\"%.0f\" height=\"%.0f\" rx=\"8\" fill=\"%s\"/>\n", width, height,
           SVG_PAPER);
}

void svg_end(void)
{
    printf("</svg>\n");
}

// Replace small numbers by 0, because a small negative number would be written as -0.00.
static double clean(double v)
{
    return fabs(v) < 0.005 ? 0.0 : v;
}

static void write_pen(struct svg_pen pen)
{
    printf(" fill=\"%s\"", pen.fill != NULL ? pen.fill : "none");
    if (pen.stroke != NULL)
        printf(" stroke=\"%s\" stroke-width=\"%.2f\" stroke-linejoin=\"round\"", pen.stroke,
               pen.width > 0.0 ? pen.width : 1.5);
    if (pen.dash != NULL)
        printf(" stroke-dasharray=\"%s\"", pen.dash);
    if (pen.opacity > 0.0)
        printf(" opacity=\"%.2f\"", pen.opacity);
    printf("/>\n");
}

void svg_line(double x0, double y0, double x1, double y1, struct svg_pen pen)
{
    printf("<line x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" y2=\"%.2f\"", clean(x0), clean(y0), clean(x1),
           clean(y1));
    write_pen(pen);
}

void svg_arrow(double x0, double y0, double x1, double y1, struct svg_pen pen)
{
    double length = hypot(x1 - x0, y1 - y0), ux = (x1 - x0) / length, uy = (y1 - y0) / length;
    double head = 4.0 + 3.0 * (pen.width > 0.0 ? pen.width : 1.5);
    double bx = x1 - head * ux, by = y1 - head * uy;
    svg_line(x0, y0, bx, by, pen);
    const double tip[3][2] = {{x1, y1},
                              {bx - 0.4 * head * uy, by + 0.4 * head * ux},
                              {bx + 0.4 * head * uy, by - 0.4 * head * ux}};
    svg_polygon(3, tip, (struct svg_pen){.fill = pen.stroke, .opacity = pen.opacity});
}

void svg_circle(double x, double y, double radius, struct svg_pen pen)
{
    printf("<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\"", clean(x), clean(y), radius);
    write_pen(pen);
}

static void write_points(const char *shape, int count, const double (*point)[2], struct svg_pen pen)
{
    int decimals = pen.decimals > 0 ? pen.decimals : 2;
    printf("<%s points=\"", shape);
    for (int i = 0; i < count; i++)
        printf("%s%.*f,%.*f", i > 0 ? " " : "", decimals, clean(point[i][0]), decimals,
               clean(point[i][1]));
    printf("\"");
    write_pen(pen);
}

void svg_polygon(int count, const double (*point)[2], struct svg_pen pen)
{
    write_points("polygon", count, point, pen);
}

void svg_path(int count, const double (*point)[2], struct svg_pen pen)
{
    write_points("polyline", count, point, pen);
}

void svg_text(double x, double y, char anchor, double size, const char *colour, const char *words)
{
    const char *where = anchor == 'm' ? "middle" : anchor == 'r' ? "end" : "start";
    printf(
        "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"%s\" font-size=\"%.0f\" fill=\"%s\">%s</text>\n",
        clean(x), clean(y), where, size, colour, words);
}

void svg_textf(double x, double y, char anchor, double size, const char *colour, const char *format,
               ...)
{
    char words[256];
    va_list list;
    va_start(list, format);
    vsnprintf(words, sizeof words, format, list);
    va_end(list);
    svg_text(x, y, anchor, size, colour, words);
}

// ---- Plots ----

static double share(double v, const double edge[2], bool logarithm)
{
    if (logarithm)
        return log10(v / edge[0]) / log10(edge[1] / edge[0]);
    return (v - edge[0]) / (edge[1] - edge[0]);
}

double svg_plot_x(const struct svg_plot *plot, double x)
{
    return plot->left + plot->width * share(x, plot->x, plot->log_x);
}

double svg_plot_y(const struct svg_plot *plot, double y)
{
    return plot->top + plot->height * (1.0 - share(y, plot->y, plot->log_y));
}

// Write a number. On a logarithmic axis, a power of ten below 0.1 or above 100 becomes 10 with an
// exponent.
static void write_number(char *words, size_t size, double v, bool logarithm)
{
    int exponent = (int)floor(log10(fmax(v, 1e-300)) + 0.5);
    if (logarithm && (exponent < -1 || exponent > 2))
        snprintf(words, size, "10<tspan dy='-5' font-size='10'>%s%d</tspan>",
                 exponent < 0 ? "&#8722;" : "", exponent < 0 ? -exponent : exponent);
    else
        snprintf(words, size, "%s%g", v < 0.0 ? "&#8722;" : "", fabs(v));
}

// The coordinate of the next tick.
static double after(double v, double step, bool logarithm)
{
    return logarithm ? 10.0 * v : v + step;
}

static void write_ticks(const struct svg_plot *plot, double step, bool along_x)
{
    const double *edge = along_x ? plot->x : plot->y;
    bool logarithm = along_x ? plot->log_x : plot->log_y;
    const struct svg_pen grid = {.stroke = SVG_PALE, .width = 0.6, .opacity = 0.5};
    double slack = logarithm ? 1e-9 * edge[1] : 1e-9 * fabs(edge[1] - edge[0]);
    for (double v = edge[0]; v <= edge[1] + slack; v = after(v, step, logarithm)) {
        char words[96];
        double rounded = fabs(v) < slack ? 0.0 : v;
        write_number(words, sizeof words, rounded, logarithm);
        if (along_x) {
            double x = svg_plot_x(plot, v), bottom = plot->top + plot->height;
            svg_line(x, plot->top, x, bottom, grid);
            svg_text(x, bottom + 18.0, 'm', 13.0, SVG_INK, words);
        } else {
            double y = svg_plot_y(plot, v);
            svg_line(plot->left, y, plot->left + plot->width, y, grid);
            svg_text(plot->left - 7.0, y + 4.0, 'r', 13.0, SVG_INK, words);
        }
    }
}

void svg_plot_frame(const struct svg_plot *plot, double x_step, double y_step, const char *x_words,
                    const char *y_words)
{
    double bottom = plot->top + plot->height;
    write_ticks(plot, x_step, true);
    write_ticks(plot, y_step, false);
    svg_line(plot->left, bottom, plot->left + plot->width, bottom,
             (struct svg_pen){.stroke = SVG_INK});
    svg_line(plot->left, plot->top, plot->left, bottom, (struct svg_pen){.stroke = SVG_INK});
    svg_text(plot->left + plot->width, bottom + 38.0, 'r', 14.0, SVG_INK, x_words);
    svg_text(plot->left - 4.0, plot->top - 10.0, 'l', 14.0, SVG_INK, y_words);
}

static bool within(const struct svg_plot *plot, const double point[2])
{
    double x = svg_plot_x(plot, point[0]), y = svg_plot_y(plot, point[1]);
    return x >= plot->left - 0.5 && x <= plot->left + plot->width + 0.5 && y >= plot->top - 0.5 &&
           y <= plot->top + plot->height + 0.5;
}

void svg_plot_curve(const struct svg_plot *plot, int count, const double (*point)[2],
                    struct svg_pen pen)
{
    double page[512][2];
    int held = 0;
    for (int i = 0; i <= count; i++) {
        bool use = i < count && within(plot, point[i]);
        if (use && held < 512) {
            page[held][0] = svg_plot_x(plot, point[i][0]);
            page[held][1] = svg_plot_y(plot, point[i][1]);
            held++;
        } else if (held > 0) {
            svg_path(held, (const double(*)[2])page, pen);
            held = 0;
        }
    }
}

// Find the points on the edges of one cell where f changes sign, in pixels. Returns the number of
// points: 0, 2 or 4.
static int crossings(const struct svg_plot *plot, const double corner[4][3], double page[4][2])
{
    int count = 0;
    for (int i = 0; i < 4; i++) {
        const double *a = corner[i], *b = corner[(i + 1) % 4];
        if ((a[2] < 0.0) == (b[2] < 0.0))
            continue;
        double s = a[2] / (a[2] - b[2]);
        page[count][0] = svg_plot_x(plot, a[0] + s * (b[0] - a[0]));
        page[count++][1] = svg_plot_y(plot, a[1] + s * (b[1] - a[1]));
    }
    return count;
}

void svg_plot_zero(const struct svg_plot *plot, double (*f)(double x, double y), struct svg_pen pen)
{
    const int columns = (int)(plot->width / 4.0), rows = (int)(plot->height / 4.0);
    double dx = (plot->x[1] - plot->x[0]) / columns, dy = (plot->y[1] - plot->y[0]) / rows;
    for (int cell = 0; cell < columns * rows; cell++) {
        double corner[4][3], page[4][2];
        for (int i = 0; i < 4; i++) { // the corners, in order around the cell
            corner[i][0] = plot->x[0] + dx * (cell % columns + (i == 1 || i == 2));
            corner[i][1] = plot->y[0] + dy * (cell / columns + (i >= 2));
            corner[i][2] = f(corner[i][0], corner[i][1]);
        }
        int count = crossings(plot, (const double(*)[3])corner, page);
        for (int i = 0; i + 1 < count; i += 2)
            svg_line(page[i][0], page[i][1], page[i + 1][0], page[i + 1][1], pen);
    }
}

void svg_pair(double top, const char *title, const char *const words[4], const double x[2],
              const double y[2], struct svg_plot plot[2])
{
    svg_text(30.0, top + 18.0, 'l', 16.0, SVG_INK, title);
    for (int i = 0; i < 2; i++) {
        double left = 30.0 + 360.0 * i;
        const double ground[4][2] = {{left, top + 30.0},
                                     {left + 340.0, top + 30.0},
                                     {left + 340.0, top + 160.0},
                                     {left, top + 160.0}};
        svg_polygon(4, ground,
                    (struct svg_pen){.fill = "#ffffff", .stroke = SVG_PALE, .width = 1.0});
        plot[i] = (struct svg_plot){left,         top + 30.0,   340.0, 130.0,
                                    {x[0], x[1]}, {y[0], y[1]}, false, false};
        svg_text(left, top + 178.0, 'l', 13.0, i == 0 ? SVG_ORANGE : SVG_BLUE, words[2 * i]);
        svg_text(left, top + 195.0, 'l', 13.0, SVG_INK, words[2 * i + 1]);
    }
}
