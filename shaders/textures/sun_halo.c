// sun_halo.c - the sun's disc and the halo of coarse dust around it: a table over the distance from
// the sun's centre and the height above the horizon, which air.h describes. Declared as sRGB and
// clamp, the table gives linear light as shares of a scale.
#include "air.h"
#include "paint.h"

int main(void)
{
    return paint_texture(SUN_COLUMNS, SUN_ROWS, 1, PAINT_COLOUR, air_sun_table);
}
