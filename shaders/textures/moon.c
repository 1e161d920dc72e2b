// moon.c - how bright the ground of the moon's near side is: dark seas, bright highlands, craters
// and their rays. 1 is an albedo of MOONSCAPE_BRIGHT.
#include "moonscape.h"

#include "paint.h"

static void moon(double u, double v, double value[3])
{
    value[0] = moonscape_albedo(u, v) / MOONSCAPE_BRIGHT;
}

int main(void)
{
    return paint_texture(MOONSCAPE_SIZE, MOONSCAPE_SIZE, 2, PAINT_NUMBER, moon);
}
