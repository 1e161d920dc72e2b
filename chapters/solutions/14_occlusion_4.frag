// Solution to exercise 14.4: one bounce with rays. Each ray that does not reach the sky brings back
// the light reflected by the point that it hits. That point is lit according to its openness, which
// is estimated from five taps.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface surface = courtyardSurface(ray, hitThreshold, maxSteps);
    lookingRound = true;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < rays * rays; i++) {
        vec2 lot = vec2(pixelRandom(2 * i), pixelRandom(2 * i + 1));
        vec2 square = (vec2(i % rays, i / rays) + lot) / float(rays);
        vec3 direction = cosineDirection(surface.normal, square);
        Ray there = shadowRay(surface.p, surface.normal, direction, 2.0 * surface.radius);
        Hit hit = march(there, 0.0, COURT_FAR, hitThreshold, maxSteps);
        vec3 p = there.origin + hit.t * direction, normal = normalAt(p, 0.002);
        float open = openOverGround(normal) * openByTaps(p, normal, reach, strength);
        sum += hit.found ? open * courtyardColour(p, 0.01) : vec3(1.0);
    }
    vec3 light = SKY * sum / float(rays * rays);
    return encodeSRGB(surface.open ? skyLight(ray.direction) : surface.colour * light);
}
