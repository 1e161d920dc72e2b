// Solution of exercise 14.1: near taps count more, and an open floor still gets 1.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Place place = courtyardPlace(ray, hitThreshold, maxSteps);
    lookingRound = true;
    float hidden = 0.0, sum = 0.0, weight = 1.0;
    for (int k = 0; k < TAPS; k++) {
        float height = tapHeight(k, reach);
        hidden += weight * clamp(1.0 - distanceAt(place.p + height * place.normal) / height, 0.0, 1.0);
        sum += weight;
        weight *= 0.5;
    }
    float open = openOverGround(place.normal) * max(1.0 - strength * hidden / sum, 0.0);
    return encodeSRGB(place.open ? skyLight(ray.direction) : placeLight(place, open));
}
