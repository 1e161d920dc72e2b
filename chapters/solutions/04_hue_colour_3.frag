// Solution to exercise 04.3: the stage as a continuous colour wheel. The hue is the angle, and the
// saturation grows from 0 in the middle to 1 at the edge.
//
// The chapter's colourAt gives the colour of everything else. On the axis, where GLSL leaves
// atan(0, 0) undefined, the angle is 0.
#include "main.glsl"
#define colourAt chapterColourAt
#define rayColour chapterRayColour
#include "04_hue_colour.frag"
#undef rayColour
#undef colourAt

vec3 colourAt(vec3 p)
{
    vec3 disc = hsvToRGB(degrees(atan(p.z, p.x + float(p.xz == vec2(0.0)))) + hueShift, clamp(length(p.xz) / 3.2, 0.0, 1.0), 0.6);
    return stageDistance(p) < min(wheelDistance(p), middleDistance(p)) ? disc : chapterColourAt(p);
}

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        light = colourAt(p) * receivedLight(p, normalAt(p, normalStep));
    }
    return encodeSRGB(light);
}
