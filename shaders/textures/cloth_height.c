// cloth_height.c - the heights of the threads of cloth.c, for bumps.
#include "weave.h"

#include "paint.h"

static void cloth_height(double u, double v, double value[3])
{
    value[0] = weave_at(u, v).height;
}

int main(void)
{
    return paint_texture(512, 512, 2, PAINT_NUMBER, cloth_height);
}
