// Solution to exercise 06.3: the exact distance instead of the distance computed from the planes.
// The march takes fewer steps, but each step costs more.
//
// A macro replaces the chapter's call to sdSierpinskiPlanes with a call to sdSierpinski.
#include "main.glsl"
#include "symmetry.glsl"
#define sdSierpinskiPlanes sdSierpinski
#include "06_sierpinski_symmetry.frag"
