// Experiment of chapter 02: the report's colour, min(object, light) (section 1.5.5), instead of the
// product. On white objects the two formulas agree; an orange object under dim white light turns
// yellow.
//
// The chapter's rayColour is renamed and not used; everything else is as in the chapter.
#include "main.glsl"
#define rayColour rightRayColour
#include "02_lighting.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        light = min(objectColour, receivedLight(p, normalAt(p, normalStep)));
    }
    return encoded ? encodeSRGB(light) : light;
}
