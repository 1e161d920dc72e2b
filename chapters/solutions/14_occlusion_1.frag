// Solution to exercise 14.1: near taps count more, and the openness of an open floor is still 1.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface surface = courtyardSurface(ray, hitThreshold, maxSteps);
    lookingRound = true;
    float hidden = 0.0, sum = 0.0, weight = 1.0;
    for (int k = 0; k < TAPS; k++) {
        float height = tapHeight(k, reach);
        hidden += weight * clamp(1.0 - distanceAt(surface.p + height * surface.normal) / height, 0.0, 1.0);
        sum += weight;
        weight *= 0.5;
    }
    float open = openOverGround(surface.normal) * max(1.0 - strength * hidden / sum, 0.0);
    return encodeSRGB(surface.open ? skyLight(ray.direction) : surfaceLight(surface, open));
}
