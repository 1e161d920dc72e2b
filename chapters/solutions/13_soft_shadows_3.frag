// Solution to exercise 13.3: the light comes from a square window instead of the sun's disc.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour

float windowReaching(Ray ray, float far)
{
    float arrived = 0.0;
    for (int i = 0; i < rays * rays; i++) {
        vec2 lot = vec2(pixelRandom(2 * i), pixelRandom(2 * i + 1));
        vec2 square = (vec2(i % rays, i / rays) + lot) / float(rays);
        vec3 direction = lampDirection(ray.direction, spread, 2.0 * square - 1.0);
        arrived += lightReaching(Ray(ray.origin, direction), far, hitThreshold, maxSteps);
    }
    return arrived / float(rays * rays);
}

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface surface = surfaceAt(ray);
    Ray there = sunRay(surface, toSun);
    float seen = windowReaching(there, sunReach(surface, there));
    return encodeSRGB(surfaceLight(surface, ray, toSun, seen));
}
