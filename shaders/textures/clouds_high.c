// clouds_high.c - a layer of cirrus seen from below: the share of the light that it blocks. Its
// fibres run along u, bent by the wind, in fields with gaps between them.
#include "paint.h"

static void clouds_high(double u, double v, double value[3])
{
    double bend = 0.16 * (paint_octaves(u, v, 3, 3, 2, 41) - 0.5) +
                  0.03 * (paint_octaves(u, v, 9, 9, 2, 43) - 0.5);
    double comb = paint_octaves(u + 0.6 * bend, v + bend, 4, 26, 4, 47);
    double lace = paint_octaves(u + 0.5 * bend, v + 1.3 * bend, 20, 60, 3, 53);
    double field = paint_octaves(u, v + bend, 3, 4, 3, 59);
    double fibres = paint_step(0.3, 0.85, 0.75 * comb + 0.25 * lace);
    value[0] = paint_step(0.42, 0.8, field) * fibres;
}

int main(void)
{
    return paint_texture(512, 512, 1, PAINT_NUMBER, clouds_high);
}
