// cloth_height.c - how high the threads of cloth.c lie: for bumps.
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
