// For projection.c: two equal upright plates, one behind the other, or a strip on the ground, in
// white on black.

#include "main.glsl"
#include "orthographic.glsl"
#include "march.glsl"
#include "primitives.glsl"

uniform float framingDistance; // 5 in [1, 40], scene units: from the camera's plane to the framing plane
uniform float aside;           // 0 in [-4, 4], scene units: distance of the plates from the view's axis
uniform bool  strip;           // false: the strip instead of the plates
uniform float hitThreshold;    // 0.0001 in [0.00001, 0.1], scene units: distance that counts as a hit

Ray pixelRay(vec2 screen)
{
    return projectionRay(screen, framingDistance);
}

float sceneDistance(vec3 p)
{
    if (strip)
        return sdBox(p - vec3(0.0, -1.5, -10.0), vec3(0.5, 0.001, 6.0));
    vec3 halfSize = vec3(0.5, 0.5, 0.001);
    return min(sdBox(p - vec3(aside, -1.1, -5.0), halfSize), sdBox(p - vec3(aside, 1.1, -9.0), halfSize));
}

vec3 rayColour(Ray ray)
{
    return vec3(march(ray, 0.0, 40.0, hitThreshold, 512).found ? 1.0 : 0.0);
}
