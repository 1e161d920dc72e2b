// mesh.h - closed meshes: from blocks to a cage, from a cage to a smooth surface, and to triangles.
//
// Only + - * / are used, so that a mesh is the same on every machine.
#ifndef MESH_H
#define MESH_H

// A block of a cage: a cell of a lattice, which determines its neighbours, and a box in space.
// Blocks of neighbouring cells share a face; no two blocks may share only an edge or a corner.
struct mesh_block {
    int cell[3];      // each in [0, MESH_CELLS)
    double centre[3]; // of its box
    double half[3];   // half the sides of its box
};

enum { MESH_CELLS = 16 };

// Faces with four corners each, in counter-clockwise order as seen from outside.
struct mesh {
    double (*vertex)[3]; // owned
    int vertices;
    int (*face)[4]; // owned
    int faces;
};

// The surface of some blocks. A vertex is the mean of the corners of the blocks that meet there.
// Free the result with mesh_free.
struct mesh mesh_of_blocks(const struct mesh_block *block, int count);

// One step of Catmull-Clark subdivision: each face becomes four. A closed mesh stays closed.
//   formula  a face's point is the mean of its corners; an edge's point the mean of its ends and of
//            the points of its two faces; a vertex V with n faces moves to (F + 2 E + (n - 3) V) /
//            n, where F is the mean of its faces' points and E the mean of its edges' middles
// Free the result with mesh_free; the argument still belongs to the caller.
// Source: E. Catmull, J. Clark, 'Recursively generated B-spline surfaces on arbitrary topological
// meshes', Computer-Aided Design 10 (1978).
struct mesh mesh_subdivide(const struct mesh *mesh);

void mesh_free(struct mesh *mesh);

// Triangles: three corners each, counter-clockwise as seen from outside.
struct triangles {
    double (*vertex)[3]; // owned
    int vertices;
    int (*corner)[3]; // owned
    int count;
};

// Cut each face into two triangles, along its shorter diagonal. Free with triangles_free.
struct triangles mesh_triangles(const struct mesh *mesh);
void triangles_free(struct triangles *triangles);

#endif
