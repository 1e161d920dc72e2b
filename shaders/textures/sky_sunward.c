// sky_sunward.c - the light of a clear sky along the middle of the half that contains the sun: a
// table over the sun's height and the direction's height, which air.h describes. Declared as sRGB
// and clamp, the table gives linear light as shares of a scale.
#include "air.h"
#include "paint.h"

static void table(double u, double v, double value[4])
{
    air_table(u, v, 1.0, 1.0, value);
}

int main(void)
{
    return paint_texture(AIR_COLUMNS, 3 * AIR_ROWS, 1, PAINT_FOUR, table);
}
