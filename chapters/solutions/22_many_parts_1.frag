// Solution to exercise 22.1: how long the lists are. The cell of a point contains the length of its list.
#include "main.glsl"
#define rayColour chapterColour
#include "22_many_parts.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec2 interval = reefInterval(ray);
    Hit hit = marchReef(ray, interval.x, interval.y, hitThreshold, footprint * pixelSpread(), maxSteps);
    Cell cell = cellAt(ray.origin + hit.t * ray.direction);
    return vec3(hit.found ? float(cell.count) / 64.0 : 0.0);
}
