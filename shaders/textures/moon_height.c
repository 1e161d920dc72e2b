// moon_height.c - how high the ground of moon.c lies: for shadows and light where the sun is low.
#include "moonscape.h"

#include "paint.h"

static void moon_height(double u, double v, double value[3])
{
    value[0] = 0.5 + moonscape_height(u, v) / MOONSCAPE_RANGE;
}

int main(void)
{
    return paint_texture(MOONSCAPE_SIZE, MOONSCAPE_SIZE, 2, PAINT_NUMBER, moon_height);
}
