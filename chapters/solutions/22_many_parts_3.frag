// Solution to exercise 22.3: a march that does not know the cells. The distance is a lower bound, so the march of
// chapter 01 steps over nothing; but where a list is not empty, no step is longer than the margin.
#include "main.glsl"
#define rayColour chapterColour
#include "22_many_parts.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec2 interval = reefInterval(ray);
    march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    return countColour(asked);
}
