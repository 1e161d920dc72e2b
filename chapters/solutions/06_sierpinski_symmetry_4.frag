// Solution of exercise 06.4: no more levels than the eye can tell apart. A tetrahedron is cut while its
// edge is longer than detail footprints, as seen from the eye.
//
// The chapter's call of sdSierpinskiPlanes is turned into a call of seenPyramid.
#include "main.glsl"
#include "cone.glsl"
#include "symmetry.glsl"

uniform float detail; // 4 in [1, 64] step 1, half pixels: edges that are shorter are not cut

vec3 scenePoint(vec3 p);

float seenPyramid(vec3 p, float size, int levels)
{
    float away = length(scenePoint(p) - iCameraPosition);
    float edge = 2.8284271 * size;
    float wanted = log2(edge / (detail * pixelSpread() * away));
    return sdSierpinskiPlanes(p, size, min(levels, int(max(ceil(wanted), 0.0))));
}

#define sdSierpinskiPlanes seenPyramid
#include "06_sierpinski_symmetry.frag"

// The way back from the pyramid's axes: the transposed matrix.
vec3 scenePoint(vec3 p)
{
    return p * TO_PYRAMID + PYRAMID;
}
