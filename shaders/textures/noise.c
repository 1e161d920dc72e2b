// noise.c - a volume of value noise: 64 slices of 64 x 64, one below the other.
//
// There are random numbers at the corners of 16 x 16 x 16 cells, which repeat; between them, the
// values follow a polynomial whose slope and curvature are 0 at the corners. A cell is 4 texels
// wide, so that the linear interpolation between texels, which is all that a graphics card does,
// stays close to the polynomial.
#include "paint.h"

#include <math.h>

enum { SIDE = 64, CELLS = 16 };

// The slices are numbered downwards; within a slice, as in every texture, v runs upwards.
static void noise(double u, double v, double value[3])
{
    double row = (1.0 - v) * SIDE, slice = floor(row);
    double z = (slice + 0.5) * CELLS / SIDE, k = floor(z), y = 1.0 - (row - slice);
    double near = paint_noise(u, y, CELLS, CELLS, (uint32_t)k);
    double far = paint_noise(u, y, CELLS, CELLS, (uint32_t)(k + 1.0) % CELLS);
    value[0] = near + paint_step(0.0, 1.0, z - k) * (far - near);
}

int main(void)
{
    return paint_texture(SIDE, SIDE * SIDE, 1, PAINT_NUMBER, noise);
}
