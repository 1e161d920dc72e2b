// turf.c - a mountain meadow from above: tufts of grass, green in some parts and straw-coloured in
// others, with a few flowers between them.
#include "paint.h"

enum { TUFTS = 20, FLOWERS = 70 }; // across a period

static const uint32_t blades[4] = {0x1f2a12, 0x43541f, 0x6d7432, 0x9a8f52};

static void turf(double u, double v, double value[3])
{
    double du = 0.05 * (paint_octaves(u, v, 24, 24, 3, 5) - 0.5);
    struct paint_grain tuft = paint_grain(u + du, v + du, TUFTS, TUFTS, 1);
    double lean = paint_random((int)(tuft.name >> 4), 0, tuft.name);
    double fine = paint_octaves(u, v, 64, 32, 3, 9), cross = paint_octaves(u, v, 32, 64, 3, 11);
    double blade = lean < 0.5 ? fine : cross, thick = paint_octaves(u, v, 5, 5, 3, 3);
    double tone = 0.15 + 0.5 * thick + 0.75 * (blade - 0.5) +
                  0.25 * paint_step(0.0, 0.12, tuft.edge) * (lean - 0.3);
    paint_scale(4, blades, tone, value);
    struct paint_grain flower = paint_grain(u, v, FLOWERS, FLOWERS, 2);
    double lot = paint_random((int)(flower.name >> 4), 1, flower.name);
    if (lot < 0.012 && flower.edge > 0.25)
        paint_colour(lot < 0.006 ? 0xe8e2c0u : 0xd8c040u, value);
}

int main(void)
{
    return paint_texture(256, 256, 3, PAINT_COLOUR, turf);
}
