// Solution to exercise 22.2: what a shadow costs. The parts that were evaluated before the shadow ray are subtracted.
#include "main.glsl"
#define rayColour chapterColour
#include "22_many_parts.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec2 interval = reefInterval(ray);
    Hit hit = marchReef(ray, interval.x, interval.y, hitThreshold, footprint * pixelSpread(), maxSteps);
    vec3 p = ray.origin + hit.t * ray.direction;
    Skin skin = skinAt(p, hit.found);
    int before = asked;
    float radius = hitThreshold + pixelSpread() * hit.t;
    Ray there = shadowRay(p, skin.normal, TO_SUN, 2.0 * radius + 0.004);
    float reach = hit.found ? shadowReach(skin.normal, TO_SUN, min(reefInterval(there).y, 8.0)) : 0.0;
    sunSeen(there, reach);
    return countColour(asked - before);
}
