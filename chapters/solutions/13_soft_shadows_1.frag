// Solution to exercise 13.1: in the penumbra, the light decreases as the visible share of a disc
// does, not linearly.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface surface = surfaceAt(ray);
    Ray there = sunRay(surface, toSun);
    Clearance clearance = clearanceAlong(there, 0.0, sunReach(surface, there), hitThreshold, maxSteps);
    float clear = clearance.least / spread;          // at least 0; may exceed 1
    float seen = discBesideEdge(2.0 * clear - 1.0);
    return encodeSRGB(surfaceLight(surface, ray, toSun, seen));
}
