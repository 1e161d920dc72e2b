// mesh_distance.h - the signed distance to a closed mesh of triangles.
//
// The distance is the distance to the nearest triangle, found with a tree of boxes. Its sign is the
// sign of the dot product of the vector from the nearest point to p and the normal at the nearest
// point. This is the normal of the face, the edge or the vertex on which that point lies. The
// normal of a vertex is the sum of its faces' normals, weighted by the faces' angles there.
// docs/23_stored_distances.md proves that this sign is right for every closed mesh that does not
// cross itself.
#ifndef MESH_DISTANCE_H
#define MESH_DISTANCE_H

#include "mesh.h"

enum { MESH_LEAF = 4 }; // the largest number of triangles in a leaf

// A box of the tree, turned along its triangles, which begin at order[first]. A leaf has no
// children; the children of any other box are left and left + 1.
struct mesh_box {
    double axis[3][3];      // unit vectors, perpendicular to each other
    double low[3], high[3]; // the ranges of its points' coordinates on these axes
    int first, count;
    int left; // 0 for a leaf
};

struct mesh_tree {
    const struct triangles *triangles; // owned by the caller; must outlive the tree
    double (*normal)[7][3]; // of each triangle: face, edges 01 12 20, vertices 0 1 2; owned
    int *order;             // owned
    struct mesh_box *box;   // box[0] contains all; owned
    int boxes;
};

// The part of a triangle that is nearest to a point: an index into mesh_tree.normal.
enum mesh_feature { MESH_FACE, MESH_EDGE_01, MESH_EDGE_12, MESH_EDGE_20, MESH_VERTEX_0 };

// The point of a triangle that is nearest to p.
//   corner   its three corners, not on one line
//   nearest  receives the point
// Returns the part of the triangle on which that point lies; MESH_VERTEX_0 + i for corner i.
// Source: C. Ericson, 'Real-time collision detection' (2005), section 5.1.5.
int mesh_nearest(const double *const corner[3], const double p[3], double nearest[3]);

// Build the tree and the normals. Free with mesh_tree_free.
//   triangles  closed: each edge belongs to two triangles, which traverse it in opposite directions
struct mesh_tree mesh_tree_build(const struct triangles *triangles);
void mesh_tree_free(struct mesh_tree *tree);

// The distance from p to the mesh, positive outside, negative inside; exact except for rounding.
double mesh_distance(const struct mesh_tree *tree, const double p[3]);

// The angle between two nonzero vectors, in [0, pi] radians, within 1e-12. The function does not
// use the C library's acos, which differs from machine to machine.
double mesh_angle(const double a[3], const double b[3]);

#endif
