#include "elephant.h"

#include <math.h>

// The blocks of the right half, and those of the middle. Each line contains a block's cell, the
// centre of its box, and half the sides of the box.
static const struct mesh_block RIGHT[] = {
    // Hind leg and foreleg: foot, shin, thigh.
    {{8, 0, 3}, {0.31, -0.83, -0.50}, {0.19, 0.05, 0.20}},
    {{8, 1, 3}, {0.30, -0.66, -0.50}, {0.165, 0.13, 0.175}},
    {{8, 2, 3}, {0.29, -0.42, -0.54}, {0.19, 0.13, 0.21}},
    {{8, 0, 6}, {0.31, -0.83, 0.44}, {0.19, 0.05, 0.20}},
    {{8, 1, 6}, {0.30, -0.66, 0.43}, {0.165, 0.13, 0.175}},
    {{8, 2, 6}, {0.29, -0.42, 0.44}, {0.18, 0.13, 0.19}},
    // Flank.
    {{8, 3, 3}, {0.29, -0.14, -0.58}, {0.20, 0.17, 0.20}},
    {{8, 3, 4}, {0.35, -0.16, -0.20}, {0.22, 0.17, 0.18}},
    {{8, 3, 5}, {0.35, -0.16, 0.15}, {0.22, 0.17, 0.17}},
    {{8, 3, 6}, {0.28, -0.12, 0.46}, {0.18, 0.16, 0.17}},
    {{8, 4, 3}, {0.22, 0.14, -0.50}, {0.15, 0.15, 0.19}},
    {{8, 4, 4}, {0.27, 0.22, -0.20}, {0.17, 0.19, 0.18}},
    {{8, 4, 5}, {0.27, 0.22, 0.13}, {0.17, 0.19, 0.17}},
    {{8, 4, 6}, {0.20, 0.16, 0.42}, {0.13, 0.16, 0.16}},
    // Ear: a narrow root, and a fan of six blocks.
    {{8, 5, 8}, {0.34, 0.36, 0.76}, {0.12, 0.13, 0.08}},
    {{9, 5, 8}, {0.56, 0.32, 0.68}, {0.13, 0.17, 0.08}},
    {{9, 6, 8}, {0.56, 0.62, 0.68}, {0.13, 0.13, 0.075}},
    {{9, 4, 8}, {0.54, -0.02, 0.70}, {0.12, 0.17, 0.075}},
    {{10, 5, 8}, {0.82, 0.30, 0.52}, {0.14, 0.17, 0.075}},
    {{10, 6, 8}, {0.78, 0.58, 0.54}, {0.10, 0.12, 0.075}},
    {{10, 4, 8}, {0.74, 0.02, 0.58}, {0.09, 0.14, 0.075}},
};

static const struct mesh_block MIDDLE[] = {
    // Body, rear to front.
    {{7, 3, 3}, {0.0, -0.16, -0.58}, {0.11, 0.17, 0.20}},
    {{7, 3, 4}, {0.0, -0.24, -0.20}, {0.13, 0.17, 0.18}},
    {{7, 3, 5}, {0.0, -0.24, 0.15}, {0.13, 0.17, 0.17}},
    {{7, 3, 6}, {0.0, -0.14, 0.46}, {0.11, 0.16, 0.17}},
    {{7, 4, 3}, {0.0, 0.22, -0.52}, {0.11, 0.17, 0.20}},
    {{7, 4, 4}, {0.0, 0.36, -0.20}, {0.13, 0.20, 0.18}},
    {{7, 4, 5}, {0.0, 0.36, 0.13}, {0.13, 0.20, 0.17}},
    {{7, 4, 6}, {0.0, 0.24, 0.42}, {0.11, 0.18, 0.16}},
    // Neck and head.
    {{7, 4, 7}, {0.0, 0.16, 0.66}, {0.20, 0.20, 0.10}},
    {{7, 4, 8}, {0.0, 0.04, 0.95}, {0.22, 0.17, 0.17}},
    {{7, 5, 8}, {0.0, 0.36, 0.92}, {0.29, 0.16, 0.24}},
    {{7, 6, 8}, {0.0, 0.62, 0.86}, {0.28, 0.13, 0.23}},
    // Trunk.
    {{7, 4, 9}, {0.0, 0.00, 1.18}, {0.165, 0.16, 0.11}},
    {{7, 3, 9}, {0.0, -0.26, 1.29}, {0.125, 0.14, 0.13}},
    {{7, 2, 9}, {0.0, -0.52, 1.35}, {0.11, 0.13, 0.11}},
    {{7, 2, 10}, {0.0, -0.60, 1.53}, {0.10, 0.10, 0.10}},
    {{7, 2, 11}, {0.0, -0.50, 1.68}, {0.09, 0.10, 0.09}},
    {{7, 3, 11}, {0.0, -0.30, 1.70}, {0.085, 0.11, 0.08}},
    // Tail.
    {{7, 4, 2}, {0.0, 0.20, -0.80}, {0.075, 0.09, 0.07}},
    {{7, 4, 1}, {0.0, 0.10, -0.92}, {0.07, 0.09, 0.07}},
    {{7, 3, 1}, {0.0, -0.16, -0.96}, {0.065, 0.17, 0.065}},
};

enum {
    RIGHT_COUNT = sizeof RIGHT / sizeof RIGHT[0],
    MIDDLE_COUNT = sizeof MIDDLE / sizeof MIDDLE[0],
    CENTRE = 7 // the middle cell along x
};

// Convert a block from the coordinates of these tables to those of the cube from -1 to 1.
static void fit(struct mesh_block *block)
{
    static const double origin[3] = {0.0, -0.04, 0.381};
    const double scale = 0.69;
    for (int i = 0; i < 3; i++) {
        block->centre[i] = scale * (block->centre[i] - origin[i]);
        block->half[i] *= scale;
    }
}

struct triangles elephant_mesh(int steps)
{
    struct mesh_block block[2 * RIGHT_COUNT + MIDDLE_COUNT];
    int count = 0;
    for (int i = 0; i < MIDDLE_COUNT; i++)
        block[count++] = MIDDLE[i];
    for (int i = 0; i < 2 * RIGHT_COUNT; i++) {
        block[count] = RIGHT[i / 2];
        if (i % 2 == 1) {
            block[count].cell[0] = 2 * CENTRE - block[count].cell[0];
            block[count].centre[0] *= -1.0;
        }
        count++;
    }
    for (int i = 0; i < count; i++)
        fit(&block[i]);
    struct mesh mesh = mesh_of_blocks(block, count);
    for (int i = 0; i < steps; i++) {
        struct mesh fine = mesh_subdivide(&mesh);
        mesh_free(&mesh);
        mesh = fine;
    }
    struct triangles triangles = mesh_triangles(&mesh);
    mesh_free(&mesh);
    return triangles;
}

double elephant_coordinate(int i)
{
    return 2.0 * i / (ELEPHANT_SIDE - 1) - 1.0;
}

void elephant_encode(double distance, unsigned char byte[2])
{
    double share = fmin(fmax(0.5 + 0.5 * distance / ELEPHANT_RANGE, 0.0), 1.0);
    int code = (int)floor(65535.0 * share + 0.5);
    byte[0] = (unsigned char)(code / 256);
    byte[1] = (unsigned char)(code % 256);
}
