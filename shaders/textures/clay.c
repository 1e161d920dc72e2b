// The distance to a clay elephant at the points of a grid, 64 slices of 64 x 64, from -1 to 1 on
// each axis: x to the right, y upwards, z from slice to slice. Red is the high byte, green the low
// one. It is read with linear and clamp, texel by texel.
#include "elephant.h"
#include "mesh_distance.h"
#include "paint.h"

static struct mesh_tree tree;

static void texel(double u, double v, double value[3])
{
    int row = (int)((1.0 - v) * ELEPHANT_SIDE * ELEPHANT_SIDE), slice = row / ELEPHANT_SIDE;
    int x = (int)(u * ELEPHANT_SIDE), y = ELEPHANT_SIDE - 1 - row % ELEPHANT_SIDE;
    const double p[3] = {elephant_place(x), elephant_place(y), elephant_place(slice)};
    unsigned char byte[2];
    elephant_encode(mesh_distance(&tree, p), byte);
    value[0] = byte[0] / 255.0;
    value[1] = byte[1] / 255.0;
    value[2] = 0.0;
}

int main(void)
{
    struct triangles triangles = elephant_mesh(3);
    tree = mesh_tree_build(&triangles);
    int status =
        paint_texture(ELEPHANT_SIDE, ELEPHANT_SIDE * ELEPHANT_SIDE, 1, PAINT_NUMBERS, texel);
    mesh_tree_free(&tree);
    triangles_free(&triangles);
    return status;
}
