// Solution to exercise 11.2: all blends are quadratic, each with the share that belongs to it.
//
// The chapter's calls to opSmoothUnion and smoothUnionShare are replaced by calls to the quadratic
// functions.
#include "main.glsl"
#include "combine.glsl"

#define opSmoothUnion opSmoothUnionQuadratic
#define smoothUnionShare smoothUnionQuadraticShare
#include "11_materials.frag"
