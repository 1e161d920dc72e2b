// clouds_storm.c - a panorama of bad weather: towers that grow together, over a dark base.
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
                                         .seed = 9};
    cumulus_at(&storm, u, v, value);
}

int main(void)
{
    return paint_texture(2048, 320, 1, PAINT_NUMBERS, clouds_storm);
}
