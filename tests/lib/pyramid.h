// pyramid.h - the pyramid of chapter 06 in double precision.
//
// The pyramid is given by its corners in the scene. On each level, folds reflect the point in the
// planes halfway between the apex and the other corners, and the edges are then halved towards the
// apex. Unlike the shader, this code does not rotate the axes, and its normals come from cross
// products.
#ifndef TESTS_PYRAMID_H
#define TESTS_PYRAMID_H

#include "lib/mirror.h"

// The whole scene; nearest receives 1 for the pyramid, 0 for the slab.
extern const struct mirror_scene pyramid_scene;

#endif
