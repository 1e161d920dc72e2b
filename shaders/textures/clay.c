// clay.c - the distance to a clay elephant at the points of a grid, 64 slices of 64 x 64, from -1
// to 1 on each axis: x to the right, y upwards, z from slice to slice. Red is the high byte, green
// the low byte. Declare the texture as linear and clamp, and read it texel by texel.
//
// Given the name of an OBJ file, the program uses the distance to its mesh instead. The mesh must
// be closed.
#include "elephant.h"
#include "mesh_distance.h"
#include "mesh_obj.h"
#include "paint.h"
#include "report.h"
#include "shader/text_file.h"

static struct mesh_tree tree;

static void texel(double u, double v, double value[3])
{
    int row = (int)((1.0 - v) * ELEPHANT_SIDE * ELEPHANT_SIDE), slice = row / ELEPHANT_SIDE;
    int x = (int)(u * ELEPHANT_SIDE), y = ELEPHANT_SIDE - 1 - row % ELEPHANT_SIDE;
    const double p[3] = {elephant_coordinate(x), elephant_coordinate(y),
                         elephant_coordinate(slice)};
    unsigned char byte[2];
    if (x == 0 && row % ELEPHANT_SIDE == 0)
        report_progress(slice, ELEPHANT_SIDE, "slices");
    elephant_encode(mesh_distance(&tree, p), byte);
    value[0] = byte[0] / 255.0;
    value[1] = byte[1] / 255.0;
    value[2] = 0.0;
}

// Read a mesh and fit it into the box of the elephant. Returns false after reporting the error.
static bool read_mesh(const char *path, struct triangles *triangles)
{
    static const double low[3] = {-0.7, -0.562, -0.7}, high[3] = {0.7, 0.85, 0.7};
    char refused[TEXT_FILE_WHY];
    FILE *file = text_file_open(path, refused);
    const char *why = file != NULL ? mesh_read_obj(file, triangles) : refused;
    if (file != NULL)
        fclose(file);
    if (why != NULL)
        return report("clay: %s: %s", path, why);
    mesh_fit(triangles, low, high);
    return true;
}

int main(int argc, char **argv)
{
    struct triangles triangles = {0};
    if (argc > 2) {
        report("clay: usage: clay [MESH.obj] >PICTURE.png");
        return 2;
    }
    if (argc == 1)
        triangles = elephant_mesh(3);
    else if (!read_mesh(argv[1], &triangles)) {
        triangles_free(&triangles);
        return 1;
    }
    tree = mesh_tree_build(&triangles);
    int status =
        paint_texture(ELEPHANT_SIDE, ELEPHANT_SIDE * ELEPHANT_SIDE, 1, PAINT_NUMBERS, texel);
    report_progress(ELEPHANT_SIDE, ELEPHANT_SIDE, "slices");
    mesh_tree_free(&tree);
    triangles_free(&triangles);
    return status;
}
