// pyramid.h - the pyramid of chapter 06 in double precision.
//
// It is given by its corners in the scene. A fold is a reflection in the plane halfway between two
// of them, after which the tetrahedron's edges are halved towards the first. No axes are rotated,
// no loop is unrolled, and the normals come from cross products.
#ifndef TESTS_PYRAMID_H
#define TESTS_PYRAMID_H

#include "lib/mirror.h"

// The distance to the whole scene; nearest receives 1 for the pyramid, 0 for the slab.
extern const struct mirror_scene pyramid_scene;

#endif
