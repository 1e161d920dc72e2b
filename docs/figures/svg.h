// svg.h - drawing functions for the figures: a page of SVG on standard output, in pixels, y
// downwards, and a plot on it, in its own numbers, y upwards.
//
// Every number is written with two decimals, so that a figure is the same file on every machine.
// For this, a curve that measures rounding needs a pen with one decimal.
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
    int decimals;       // of the points of a polygon or a path; 0 means 2
};

void svg_line(double x0, double y0, double x1, double y1, struct svg_pen pen);
void svg_arrow(double x0, double y0, double x1, double y1, struct svg_pen pen); // head at x1, y1
void svg_circle(double x, double y, double radius, struct svg_pen pen);
void svg_polygon(int count, const double (*point)[2], struct svg_pen pen);
void svg_path(int count, const double (*point)[2], struct svg_pen pen); // not closed

// Write words.
//   anchor  'l', 'm' or 'r': x is their left end, middle or right end
//   size    pixels
//   words   SVG text: <tspan font-style='italic'> and entities are allowed
void svg_text(double x, double y, char anchor, double size, const char *colour, const char *words);
// Write words from a format, as printf does: at most 255 bytes.
void svg_textf(double x, double y, char anchor, double size, const char *colour, const char *format,
               ...) __attribute__((format(printf, 6, 7)));

// A plot: a rectangle of the page and the numbers at its edges.
struct svg_plot {
    double left, top, width, height; // pixels
    double x[2], y[2];               // numbers at the left and right, bottom and top edge
    bool log_x, log_y;               // true for a logarithmic axis
};

double svg_plot_x(const struct svg_plot *plot, double x); // pixels
double svg_plot_y(const struct svg_plot *plot, double y);

// Draw the frame with its ticks and words.
//   x_step, y_step  from tick to tick; a logarithmic axis has a tick at every power of ten instead
void svg_plot_frame(const struct svg_plot *plot, double x_step, double y_step, const char *x_words,
                    const char *y_words);

// Draw a curve through points; the parts outside the plot are left out.
void svg_plot_curve(const struct svg_plot *plot, int count, const double (*point)[2],
                    struct svg_pen pen);

// Draw the zeros of a function of the plot's two numbers, as short lines in the cells of a grid.
void svg_plot_zero(const struct svg_plot *plot, double (*f)(double x, double y),
                   struct svg_pen pen);

// Draw the surroundings of a wrong formula and of the right one beside it: two plots in a row, each
// with a background and two lines of words.
//   top    pixels, the top of the row, which is SVG_PAIR_ROW high on a page 760 wide
//   title  above both plots
//   words  two lines below the left plot, then two below the right one
//   x, y   the numbers at the edges of both plots
//   plot   receives the two plots, 340 x 130 pixels each
#define SVG_PAIR_ROW 222.0
void svg_pair(double top, const char *title, const char *const words[4], const double x[2],
              const double y[2], struct svg_plot plot[2]);

#endif
