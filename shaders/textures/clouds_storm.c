// clouds_storm.c - a panorama of bad weather: columns that grow together over a dark base, and two
// thunderheads, each in a clearing.
#include "cumulus.h"

#include "paint.h"

static void clouds_storm(double u, double v, double value[3])
{
    static const struct cumulus storm = {.base = 0.9,
                                         .depth = 7.0,
                                         .cell = 8.0,
                                         .threshold = 0.42,
                                         .slope = 2.8,
                                         .puff = 0.6,
                                         .fray = 0.3,
                                         .size = 8.0,
                                         .thickness = 25.0,
                                         .seed = 9,
                                         .tower = {{.north = 8.3,
                                                    .east = -25.7,
                                                    .width = 3.6,
                                                    .top = 12.5,
                                                    .anvil = 9.0,
                                                    .drawn = 5.0,
                                                    .clearing = 10.0},
                                                   {.north = -17.3,
                                                    .east = 31.5,
                                                    .width = 3.8,
                                                    .top = 11.5,
                                                    .anvil = 8.0,
                                                    .drawn = 4.0,
                                                    .clearing = 7.0}}};
    cumulus_at(&storm, u, v, value);
}

int main(void)
{
    return paint_texture(CUMULUS_WIDTH, CUMULUS_HEIGHT, 1, PAINT_NUMBERS, clouds_storm);
}
