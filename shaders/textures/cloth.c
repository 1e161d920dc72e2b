// cloth.c - linen, dyed with indigo: the warp darker than the weft, both paler where they were
// rubbed.
#include "weave.h"

#include "paint.h"

static void cloth(double u, double v, double value[3])
{
    static const uint32_t indigo[5] = {0x0c1230, 0x1b2857, 0x324a86, 0x5a76b0, 0xa4b6d8};
    struct weave weave = weave_at(u, v);
    uint32_t seed = weave.warp ? 31 : 32;
    // Fibres wind round the thread.
    double fibre = paint_noise(0.5 * weave.across + 48.0 * weave.along, weave.along, 5, 48,
                               seed + 8 * (uint32_t)weave.thread);
    double yarn = paint_random(weave.thread, 0, seed), dye = paint_octaves(u, v, 5, 5, 3, 33);
    double tone = 0.9 * weave.height * weave.height + 0.22 * (fibre - 0.5) + 0.14 * (yarn - 0.5) +
                  0.16 * (dye - 0.5) + (weave.warp ? -0.08 : 0.06);
    paint_scale(5, indigo, weave.covered ? tone : 0.0, value);
}

int main(void)
{
    return paint_texture(512, 512, 2, PAINT_COLOUR, cloth);
}
