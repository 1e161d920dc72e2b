// mesh_obj.h - a mesh from a Wavefront OBJ file, so that readers can bake distances to their own
// meshes.
#ifndef MESH_OBJ_H
#define MESH_OBJ_H

#include <stdio.h>

#include "mesh.h"

// Read the vertices and the faces of an OBJ file, from the lines that begin with v and f, perhaps
// after blanks. All other lines are ignored. A face with more than three corners becomes a fan of
// triangles around its first corner. An index is counted from 1, or backwards from the last vertex
// if it is negative.
//   triangles  receives the mesh; free it with triangles_free, even after an error
// Returns NULL if every triangle has an area and every edge belongs to two triangles, which
// traverse it in opposite directions, as mesh_tree_build requires. Otherwise returns one phrase
// that says what is wrong.
const char *mesh_read_obj(FILE *file, struct triangles *triangles);

// Scale and move a mesh so that it rests on the middle of the floor of a box, with y upwards, and
// is as large as the box allows. A mesh that is inside out, so that its signed volume is negative,
// is turned the right way round.
//   low, high  opposite corners of the box
void mesh_fit(struct triangles *triangles, const double low[3], const double high[3]);

#endif
