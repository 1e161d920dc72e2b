// granite.c - weathered granite: pale rose feldspar, white plagioclase, smoky quartz and black
// mica.
//
// Large crystals of feldspar lie in a matrix of small grains; the flakes of mica cluster.
#include "paint.h"

enum { LARGE = 22, SMALL = 50, FLAKES = 84 }; // grains across a period

struct mineral {
    uint32_t scale[3]; // 0xRRGGBB, from the darkest to the lightest
    double spread;     // how much the grains differ from each other
    double cleavage;   // how strongly the cleavage planes show
    double cloud;      // how uneven the inside of a grain is
};
static const struct mineral rose = {{0x79645f, 0xaa948e, 0xd1c1ba}, 0.55, 0.34, 0.60},
                            white = {{0x989490, 0xc5c2be, 0xe8e6e2}, 0.50, 0.26, 0.60},
                            quartz = {{0x4b4a4c, 0x7f7e7f, 0xb4b2b1}, 0.55, 0.05, 0.95},
                            mica = {{0x0c0b0c, 0x232122, 0x53504f}, 0.40, 0.50, 0.50};

// A random number for a grain.
static double chance(uint32_t name, int which)
{
    return paint_random((int)(name >> 4), which, name);
}

static void paint(const struct mineral *mineral, const struct paint_grain *grain, double u,
                  double v, double value[3])
{
    double slope = 2.0 * chance(grain->name, 1) - 1.0;
    double plane = paint_noise(grain->u + slope * grain->v, 0.0, 13, 1, grain->name) - 0.5;
    double cloud = paint_octaves(u, v, 60, 60, 3, 77) - 0.5;
    double tone = 0.5 + mineral->spread * (chance(grain->name, 2) - 0.5) +
                  mineral->cleavage * plane + mineral->cloud * cloud;
    paint_scale(3, mineral->scale, tone, value);
    double border = 0.80 + 0.20 * paint_step(0.0, 0.07, grain->edge);
    for (int c = 0; c < 3; c++)
        value[c] *= border;
}

static void granite(double u, double v, double value[3])
{
    // The borders between grains are irregular.
    double du = 0.020 * (paint_octaves(u, v, 36, 36, 4, 11) - 0.5);
    double dv = 0.020 * (paint_octaves(u, v, 36, 36, 4, 23) - 0.5);
    struct paint_grain flake = paint_grain(u + 0.5 * du, v + 0.5 * dv, FLAKES, FLAKES, 3);
    double crowd = paint_noise(u, v, 20, 20, 5);
    if (chance(flake.name, 0) < 0.02 + 0.32 * crowd * crowd * crowd) {
        paint(&mica, &flake, u, v, value);
        return;
    }
    struct paint_grain grain = paint_grain(u + du, v + dv, LARGE, LARGE, 1);
    double kind = chance(grain.name, 0);
    const struct mineral *mineral = kind < 0.29 ? &rose : &white;
    if (kind > 0.40) { // no large crystal
        grain = paint_grain(u + du, v + dv, SMALL, SMALL, 2);
        kind = chance(grain.name, 0);
        mineral = kind < 0.48 ? &quartz : kind < 0.86 ? &white : &rose;
    }
    paint(mineral, &grain, u, v, value);
}

int main(void)
{
    return paint_texture(512, 512, 2, PAINT_COLOUR, granite);
}
