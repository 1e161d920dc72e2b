// elephant.h - the clay elephant of chapter 23: its mesh, and how a grid stores the distance to it.
#ifndef ELEPHANT_H
#define ELEPHANT_H

#include "mesh.h"

// The number of points of the grid on each axis, from -1 to 1, and the largest distance that the
// grid stores.
enum { ELEPHANT_SIDE = 64 };
#define ELEPHANT_RANGE 0.5

// The elephant: it faces along z, y is up, and its soles are near y = -0.57. It fits into the cube
// from -1 to 1.
//   steps  of subdivision, >= 0
// Free with triangles_free.
struct triangles elephant_mesh(int steps);

// The coordinate of a point of the grid.
//   i        in [0, ELEPHANT_SIDE)
//   formula  2 i / (ELEPHANT_SIDE - 1) - 1
double elephant_coordinate(int i);

// The two bytes that store a distance: the high byte and the low byte.
//   formula  the integer nearest to 65535 (1 + distance / ELEPHANT_RANGE) / 2, with the distance
//            clamped to the range
void elephant_encode(double distance, unsigned char byte[2]);

#endif
