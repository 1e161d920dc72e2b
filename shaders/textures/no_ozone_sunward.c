// no_ozone_sunward.c - sky_sunward.png for air without ozone, for an experiment of chapter 18.
// Declare the table as sRGB and clamp.
#include "air.h"
#include "paint.h"

static void table(double u, double v, double value[4])
{
    air_table(u, v, 1.0, 0.0, value);
}

int main(void)
{
    return paint_texture(AIR_COLUMNS, 3 * AIR_ROWS, 1, PAINT_FOUR, table);
}
