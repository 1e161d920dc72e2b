// granite.c - polished granite: rose feldspar, white plagioclase, smoky quartz and black mica.
//
// Two populations of grains, coarse ones and a fine filling, with borders that wander; what a grain
// is made of is chance, but mica keeps together.
#include "paint.h"

#include <math.h>

enum { COARSE = 22, FINE = 54, MICA = 84 };

struct mineral {
    uint32_t dark, light; // 0xRRGGBB, from its darkest grain to its lightest
    double cleavage;      // how strongly its planes show
};
static const struct mineral rose = {0xa87a68, 0xd6ab98, 0.5}, white = {0xb9b0a6, 0xe6e0d6, 0.35},
                            quartz = {0x6c6a6c, 0xa9a7a8, 0.1}, black = {0x131214, 0x34302f, 0.9};

static double share_of(uint32_t name, int part)
{
    return paint_random((int)(name >> 3), part, name);
}

// A grain's own colour, brighter and darker along its cleavage.
static void paint(const struct mineral *mineral, const struct paint_grain *grain, double u,
                  double v, double value[3])
{
    double angle = 2.0 * share_of(grain->name, 1) - 1.0, across = grain->u + angle * grain->v;
    double plane = paint_noise(across, 0.0, 9, 1, grain->name) - 0.5;
    double cloud = paint_octaves(u, v, 40, 40, 3, 77) - 0.5;
    double speck = paint_noise(u, v, 256, 256, 79) - 0.5;
    double tone =
        share_of(grain->name, 2) + 0.5 * mineral->cleavage * plane + 0.5 * cloud + 0.16 * speck;
    const uint32_t scale[2] = {mineral->dark, mineral->light};
    paint_scale(2, scale, tone, value);
}

static void granite(double u, double v, double value[3])
{
    // Borders wander.
    double du = paint_octaves(u, v, 30, 30, 4, 11) - 0.5,
           dv = paint_octaves(u, v, 30, 30, 4, 23) - 0.5;
    double x = u + 0.022 * du, y = v + 0.022 * dv;
    struct paint_grain coarse = paint_grain(x, y, COARSE, COARSE, 1);
    struct paint_grain fine = paint_grain(x, y, FINE, FINE, 2);
    struct paint_grain flake = paint_grain(u + 0.008 * du, v + 0.008 * dv, MICA, MICA, 3);
    double kind = share_of(coarse.name, 0), depth = 1.0;
    const struct mineral *mineral = &rose;
    struct paint_grain grain = coarse;
    if (kind > 0.42) { // no large crystal here: the filling
        grain = fine;
        kind = share_of(fine.name, 0);
        mineral = kind < 0.42 ? &quartz : kind < 0.84 ? &white : &rose;
    } else if (kind > 0.30) {
        mineral = &white;
    }
    double crowd = paint_noise(u, v, 16, 16, 5);
    if (share_of(flake.name, 0) < 0.02 + 0.30 * crowd * crowd * crowd) {
        grain = flake;
        mineral = &black;
    }
    depth = mineral == &black ? 1.0 : 0.78 + 0.22 * paint_step(0.0, 0.06, grain.edge);
    paint(mineral, &grain, u, v, value);
    for (int c = 0; c < 3; c++)
        value[c] *= depth;
}

int main(void)
{
    return paint_texture(512, 512, 2, PAINT_COLOUR, granite);
}
