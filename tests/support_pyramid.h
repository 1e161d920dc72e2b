// support_pyramid.h - the pyramid of chapter 06 in double precision.
//
// It is written down by its corners in the scene. A fold is a reflection in the plane halfway
// between two of them, after which the tetrahedron's edges are halved towards the first. No axes
// are turned, nothing is written out, and the normals come from cross products.
#ifndef SUPPORT_PYRAMID_H
#define SUPPORT_PYRAMID_H

#include "support_mirror.h"

#define PYRAMID_SIZE 1.1

struct tetrahedron {
    struct d3 corner[4];
};

// It stands on the ground, its apex above (-0.7, -0.5), one lower corner towards the viewer. An
// edge is sqrt(8) size.
struct tetrahedron pyramid_whole(void);

// The unit normal of the face opposite corner k, pointing out; the signed distance to its plane.
struct d3 pyramid_normal(const struct tetrahedron *t, int k);
double pyramid_face(const struct tetrahedron *t, int k, struct d3 p);

// The largest of the four.
double pyramid_planes(const struct tetrahedron *t, struct d3 p);

// One level: p to the apex's side, the edges halved towards the apex. True when p was moved.
bool pyramid_fold(struct tetrahedron *t, struct d3 *p);

// The centre and half size of the slab that it stands on.
extern const struct d3 pyramid_slab, pyramid_slab_half;

// The distance of the whole scene; nearest receives 1 for the pyramid, 0 for the slab.
extern const struct mirror_scene pyramid_scene;

#endif
