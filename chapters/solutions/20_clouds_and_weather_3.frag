// Solution to exercise 20.3: clouds in front of the sun cast a shadow on coast and sea.
#include "main.glsl"
#define rayColour chapterColour
#include "20_clouds_and_weather.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    Lights lights = lightsAt(timeOfDay + hoursPerSecond * iTime);
    float cover = cloudOver(lowClouds(lights.sun, 0.05), highClouds(lights.sun, 0.05)).cover;
    lights.low *= 1.0 - 0.85 * cover;
    Surface surface = surfaceAlong(ray);
    vec3 sky = skyWithClouds(surface.seen.direction, lights, skyWidth(surface));
    return developed(surfaceLight(surface, ray.direction, sky, lights), surface, lights);
}
