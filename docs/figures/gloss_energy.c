// gloss_energy.c - the share of the light that a surface of tiny mirrors reflects, against the
// roughness of the surface.
#include "lib/gloss.h"
#include "svg.h"

enum { POINTS = 19 };

static void curve(const struct svg_plot *plot, gloss_model *model, double cosine,
                  struct svg_pen pen)
{
    double point[POINTS][2];
    for (int i = 0; i < POINTS; i++) {
        double r = 0.1 + 0.05 * i, parameter = model == gloss_ggx ? r : gloss_exponent(r);
        point[i][0] = r;
        point[i][1] = gloss_albedo(model, parameter, r, cosine);
    }
    svg_plot_curve(plot, POINTS, (const double(*)[2])point, pen);
}

int main(void)
{
    const struct svg_plot left = {70.0, 40.0, 290.0, 210.0, {0.1, 1.0}, {0.0, 1.1}, false, false};
    const struct svg_plot right = {440.0, 40.0, 290.0, 210.0, {0.1, 1.0}, {0.0, 1.1}, false, false};
    const double cosine[3] = {1.0, 0.5, 0.173648177666930};
    const char *const colour[3] = {SVG_BLUE, SVG_TEAL, SVG_ORANGE};
    const char *const dash[3] = {NULL, "8 4", "2 4"};
    svg_begin(
        760.0, 330.0, "The share of light that is reflected",
        "Two plots of the share of light that is reflected, against roughness, for light that "
        "arrives straight on, at 60 and at 80 degrees. GGX reflects nearly all light while the "
        "surface is smooth, then less: at roughness 1 the share is 0.31 straight on, 0.45 at "
        "60 degrees and 0.67 at 80. Blinn and Phong reflect all light straight on, but on a "
        "smooth surface only a quarter at 60 degrees and 0.03 at 80.");
    svg_plot_frame(&left, 0.1, 0.2, "roughness", "GGX");
    svg_plot_frame(&right, 0.1, 0.2, "roughness", "Blinn and Phong");
    for (int i = 0; i < 3; i++) {
        const struct svg_pen pen = {.stroke = colour[i], .width = 2.4, .dash = dash[i]};
        curve(&left, gloss_ggx, cosine[i], pen);
        curve(&right, gloss_blinn_phong, cosine[i], pen);
    }
    svg_text(70.0, 318.0, 'l', 14.0, SVG_INK, "light");
    svg_text(120.0, 318.0, 'l', 14.0, SVG_BLUE, "solid: straight on");
    svg_text(290.0, 318.0, 'l', 14.0, SVG_TEAL, "dashed: at 60°");
    svg_text(440.0, 318.0, 'l', 14.0, SVG_ORANGE, "dotted: at 80°");
    svg_end();
    return 0;
}
