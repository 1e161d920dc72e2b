// Experiment of chapter 04: the report's colour, min(object, light) (section 1.5.5), instead of the
// product, on objects that have a hue.
//
// A macro renames the chapter's rayColour, which is not used; everything else is as in the chapter.
#include "main.glsl"
#define rayColour rightRayColour
#include "04_hue_colour.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        light = min(colourAt(p), receivedLight(p, normalAt(p, normalStep)));
    }
    return encodeSRGB(light);
}
