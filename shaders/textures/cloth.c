// cloth.c - linen, dyed with indigo: the warp is darker than the weft, and both are paler where
// they have been rubbed.
#include "weave.h"

#include "paint.h"

static void cloth(double u, double v, double value[3])
{
    static const uint32_t indigo[6] = {0x070b1e, 0x141d45, 0x25366e, 0x3f5792, 0x6c86b6, 0xb3c1dc};
    struct weave weave = weave_at(u, v);
    uint32_t seed = weave.warp ? 31 : 32;
    // Fibres wind around the thread.
    double fibre = paint_noise(0.5 * weave.across + 32.0 * weave.along, weave.along, 4, 64,
                               seed + 8 * (uint32_t)weave.thread) -
                   0.5;
    double yarn = paint_random(weave.thread, 0, seed) - 0.5;
    double fade = paint_noise(weave.along, (weave.thread + 0.5) / WEAVE_THREADS, 14, WEAVE_THREADS,
                              seed + 4) -
                  0.5;
    double dye = paint_octaves(u, v, 5, 5, 3, 33) - 0.5;
    double tone = 0.16 + 0.52 * weave.height * weave.height + 0.20 * fibre + 0.20 * yarn +
                  0.14 * fade + 0.07 * dye + (weave.warp ? -0.07 : 0.07);
    paint_scale(6, indigo, weave.covered ? tone : 0.0, value);
}

int main(void)
{
    return paint_texture(512, 512, 2, PAINT_COLOUR, cloth);
}
