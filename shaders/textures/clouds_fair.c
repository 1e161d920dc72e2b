// clouds_fair.c - a panorama of fair weather: cumulus with flat bases and gaps between them.
#include "cumulus.h"

#include "paint.h"

static void clouds_fair(double u, double v, double value[3])
{
    static const struct cumulus fair = {.base = 1.1,
                                        .depth = 2.6,
                                        .cell = 3.4,
                                        .threshold = 0.56,
                                        .slope = 3.6,
                                        .puff = 0.55,
                                        .fray = 0.3,
                                        .size = 3.0,
                                        .thickness = 40.0,
                                        .tuft = {{-0.1, 0.62, 1.1}, {0.5, -0.5, 0.75}},
                                        .seed = 5};
    cumulus_at(&fair, u, v, value);
}

int main(void)
{
    return paint_texture(CUMULUS_WIDTH, CUMULUS_HEIGHT, 1, PAINT_NUMBERS, clouds_fair);
}
