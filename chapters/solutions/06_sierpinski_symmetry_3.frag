// Solution of exercise 06.3: the exact distance in place of the planes'. Fewer steps, each of which costs more.
//
// The chapter's call of sdSierpinskiPlanes is turned into a call of sdSierpinski.
#include "main.glsl"
#include "symmetry.glsl"
#define sdSierpinskiPlanes sdSierpinski
#include "06_sierpinski_symmetry.frag"
