// svg.h - drawing functions for the figures. They write a page of SVG to standard output. Positions
// on the page are in pixels, with y downwards; a plot on the page has its own coordinates, with y
// upwards.
//
// Positions are written with two decimals, so that a figure is the same file on every machine. A
// curve of rounding errors differs slightly between machines: draw it with a pen that writes only
// one decimal.
#ifndef SVG_H
#define SVG_H

#include <stdbool.h>

// Colours that a colour-blind reader can distinguish, because they also differ in lightness. They
// are on a paper-coloured background, so that a figure looks the same in a light and in a dark
// theme.
#define SVG_INK    "#0d1433"
#define SVG_PALE   "#9aa0b5"
#define SVG_ORANGE "#d9731a"
#define SVG_SAND   "#fce1b8"
#define SVG_BLUE   "#2f6fc0"
#define SVG_SKY    "#cfe0f5"
#define SVG_TEAL   "#0b7f73"
#define SVG_PAPER  "#fffbf2"

// Begin and end the page.
//   width, height       pixels
//   title, description  say what the figure is and what it shows, for a reader who cannot see it
void svg_begin(double width, double height, const char *title, const char *description);
void svg_end(void);

// The style of lines and shapes.
struct svg_pen {
    const char *stroke; // colour, or NULL for none
    double width;       // pixels; 0 means 1.5
    const char *fill;   // colour, or NULL for none
    const char *dash;   // as SVG's stroke-dasharray; NULL for a solid line
    double opacity;     // 0 means 1
    int decimals;       // number of decimals in the points of a polygon or a path; 0 means 2
};

void svg_line(double x0, double y0, double x1, double y1, struct svg_pen pen);
void svg_arrow(double x0, double y0, double x1, double y1, struct svg_pen pen); // head at x1, y1
void svg_circle(double x, double y, double radius, struct svg_pen pen);
void svg_polygon(int count, const double (*point)[2], struct svg_pen pen);
void svg_path(int count, const double (*point)[2], struct svg_pen pen); // not closed

// Write words.
//   anchor  'l', 'm' or 'r': x is the left end, the middle or the right end of the words
//   size    font size, pixels
//   words   SVG text: <tspan font-style='italic'> and entities are allowed
void svg_text(double x, double y, char anchor, double size, const char *colour, const char *words);
// Write words from a format, as printf does. Words longer than 255 bytes are truncated.
void svg_textf(double x, double y, char anchor, double size, const char *colour, const char *format,
               ...) __attribute__((format(printf, 6, 7)));

// A plot: a rectangle of the page and the coordinates of its edges.
struct svg_plot {
    double left, top, width, height; // pixels
    double x[2], y[2];               // coordinates of the left and right, bottom and top edges
    bool log_x, log_y;               // true for a logarithmic axis
};

// Convert a plot's coordinate to pixels on the page.
double svg_plot_x(const struct svg_plot *plot, double x);
double svg_plot_y(const struct svg_plot *plot, double y);

// Draw the two axes of a plot, with grid lines, numbers and words.
//   x_step, y_step  spacing of the grid lines; on a logarithmic axis, which ignores the spacing,
//                   each line is at ten times the coordinate of the line before
void svg_plot_frame(const struct svg_plot *plot, double x_step, double y_step, const char *x_words,
                    const char *y_words);

// Draw a curve through points. Points outside the plot are omitted and interrupt the curve.
void svg_plot_curve(const struct svg_plot *plot, int count, const double (*point)[2],
                    struct svg_pen pen);

// Draw the curve on which a function of the plot's x and y is zero, as short lines in the cells of
// a grid.
void svg_plot_zero(const struct svg_plot *plot, double (*f)(double x, double y),
                   struct svg_pen pen);

// Draw a row of two empty plots, each with a background and two lines of words below: the left plot
// for a wrong formula, and the right plot for the correct formula.
//   top    the top of the row, pixels; the row is SVG_PAIR_ROW high, on a page 760 wide
//   title  written above both plots
//   words  two lines below the left plot, then two below the right plot
//   x, y   the coordinates of the edges of both plots
//   plot   receives the two plots, 340 x 130 pixels each
#define SVG_PAIR_ROW 222.0
void svg_pair(double top, const char *title, const char *const words[4], const double x[2],
              const double y[2], struct svg_plot plot[2]);

#endif
