// painted_sky.c - a sky painted by eye, for an exercise of chapter 18. The sine of the sun's height
// increases to the right, from -1 to 1, and that of the direction's height upwards, from 0 to 1.
// The lower storey is the half of the sky that contains the sun, and the upper storey is the other
// half. The colours are those that the screen should show. Declare the table as sRGB and clamp.
#include <math.h>

#include "paint.h"

// The colours from night through dusk, sunset and morning to noon.
static const uint32_t zenith[9] = {0x0a0e1c, 0x0a0e1c, 0x0c1224, 0x1c2850, 0x44588e,
                                   0x4f7cc0, 0x4a80cc, 0x4480d0, 0x4080d0};
static const uint32_t horizon[9] = {0x121a2c, 0x121a2c, 0x1c2238, 0x6a4a5e, 0xf0884a,
                                    0xe8d8b8, 0xc6dcea, 0xb8d6ee, 0xb4d4f0};
static const uint32_t opposite[9] = {0x121a2c, 0x121a2c, 0x181e34, 0x3a3c5c, 0xa888a0,
                                     0xb8c8d8, 0xb8d2e8, 0xb4d2ec, 0xb0d0ee};

static void sky(double u, double v, double value[3])
{
    double storey = v < 0.5 ? 0.0 : 1.0, row = 2.0 * v - storey, low[3], high[3];
    // Most of the colours are needed around sunset.
    double sun = 2.0 * u - 1.0,
           x = 0.5 + 0.5 * (sun < 0.0 ? -1.0 : 1.0) * sqrt(sun < 0.0 ? -sun : sun);
    double down = (1.0 - row) * (1.0 - row) * (1.0 - row);
    paint_scale(9, storey < 0.5 ? horizon : opposite, x, low);
    paint_scale(9, zenith, x, high);
    for (int c = 0; c < 3; c++)
        value[c] = high[c] * (storey < 0.5 ? 1.0 : 0.8) + down * (low[c] - high[c]);
}

int main(void)
{
    return paint_texture(64, 128, 2, PAINT_COLOUR, sky);
}
