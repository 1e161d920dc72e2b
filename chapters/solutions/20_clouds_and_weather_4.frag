// Solution to exercise 20.4: a rainbow.
#include "main.glsl"
#define rayColour chapterColour
#include "20_clouds_and_weather.frag"
#undef rayColour

// The light of the bow in a direction: bands around the point opposite the sun.
vec3 rainbow(vec3 direction, Lights lights)
{
    float angle = degrees(atan(length(cross(direction, lights.sun)), -dot(direction, lights.sun)));
    vec3 off = (angle - vec3(42.4, 41.6, 40.7)) / 0.6;
    return 0.06 * rainShare(weather) * lights.strength * tableSunlight(lights.sun) * exp(-off * off);
}

vec3 rayColour(Ray ray)
{
    Lights lights = lightsAt(timeOfDay + hoursPerSecond * iTime);
    Surface surface = surfaceAlong(ray);
    vec3 sky = skyWithClouds(surface.seen.direction, lights, skyWidth(surface));
    vec3 light = surfaceLight(surface, ray.direction, sky, lights) + rainbow(ray.direction, lights);
    return developed(light, surface, lights);
}
