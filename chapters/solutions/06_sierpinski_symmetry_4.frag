// Solution to exercise 06.4: no more levels than the eye can distinguish. A tetrahedron is divided
// while its edge, as seen from the eye, is longer than the parameter `detail`, in half pixels.
//
// A macro replaces the chapter's call to sdSierpinskiPlanes with a call to seenPyramid.
#include "main.glsl"
#include "cone.glsl"
#include "symmetry.glsl"

uniform float detail; // 4 in [1, 64] step 1, half pixels: shorter edges are not divided

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

// Map a point in the pyramid's coordinates back to the scene, with the transposed matrix.
vec3 scenePoint(vec3 p)
{
    return p * TO_PYRAMID + PYRAMID;
}
