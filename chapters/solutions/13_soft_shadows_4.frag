// Solution to exercise 13.4: one shadow ray per sample. Each sample has a different cell of the grid
// over the disc.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour

// The result of one of the pixel's iSamples shadow rays; iSamples is a square number.
float oneReaching(Ray ray, float far)
{
    int side = int(sqrt(float(iSamples)) + 0.5);
    vec2 lot = vec2(pixelRandom(0), pixelRandom(1));
    vec2 square = (vec2(iSample % side, iSample / side) + lot) / float(side);
    vec3 direction = lampDirection(ray.direction, spread, discPoint(square));
    return lightReaching(Ray(ray.origin, direction), far, hitThreshold, maxSteps);
}

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface surface = surfaceAt(ray);
    Ray there = sunRay(surface, toSun);
    float seen = oneReaching(there, sunReach(surface, there));
    return encodeSRGB(surfaceLight(surface, ray, toSun, seen));
}
