// Solution to exercise 14.3: a sky three times as bright at the zenith as at the horizon; an open
// floor receives as much light as before.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface surface = courtyardSurface(ray, hitThreshold, maxSteps);
    lookingRound = true;
    float sum = 0.0;
    for (int i = 0; i < rays * rays; i++) {
        vec2 lot = vec2(pixelRandom(2 * i), pixelRandom(2 * i + 1));
        vec2 square = (vec2(i % rays, i / rays) + lot) / float(rays);
        vec3 direction = cosineDirection(surface.normal, square);
        Ray there = shadowRay(surface.p, surface.normal, direction, 2.0 * surface.radius);
        float bright = (3.0 + 6.0 * max(direction.y, 0.0)) / 7.0;
        sum += bright * lightReaching(there, COURT_FAR, hitThreshold, maxSteps);
    }
    float open = sum / float(rays * rays);
    return encodeSRGB(surface.open ? skyLight(ray.direction) : surfaceLight(surface, open));
}
