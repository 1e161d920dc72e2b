// Solution to exercise 02.3: ambient light that comes only from above the horizon. A surface that
// is tilted away from the zenith receives less of this light: the fraction (1 + N.y) / 2.
#include "main.glsl"
#define rayColour chapterRayColour
#include "02_lighting.frag"
#undef rayColour

uniform vec3 skyAbove; // 0.12, 0.2, 0.35 in [0, 1], linear RGB: the ambient light on an upward face

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, normalStep);
        vec3 lamps = receivedLight(p, normal) - ambient;
        light = objectColour * (lamps + skyAbove * (0.5 + 0.5 * normal.y));
    }
    return encoded ? encodeSRGB(light) : light;
}
