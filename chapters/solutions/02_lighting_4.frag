// Solution to exercise 02.4: four rays per pixel, averaged in linear light and encoded once.
#include "main.glsl"
#define rayColour chapterRayColour
#include "02_lighting.frag"
#undef rayColour

uniform bool linearMean; // true: average linear light; false: average encoded light, as --samples does

// The linear light that one ray finds, clamped to the range that the screen can show.
vec3 linearColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    vec3 p = ray.origin + hit.t * ray.direction;
    vec3 matt = objectColour * receivedLight(p, normalAt(p, normalStep));
    return clamp(hit.found ? matt : skyLight(ray.direction), 0.0, 1.0);
}

vec3 rayColour(Ray ray)
{
    // The vector from the eye to the point of the screen that this ray passes through.
    vec3 screen = ray.direction * focalLength / dot(ray.direction, iCameraForward);
    vec3 mean = vec3(0.0);
    for (int i = 0; i < 4; i++) {
        vec2 quarter = (vec2(float(i % 2), float(i / 2)) - 0.5) / iResolution.y;
        vec3 direction = screen + quarter.x * iCameraRight + quarter.y * iCameraUp;
        vec3 light = linearColour(Ray(ray.origin, normalize(direction)));
        mean += 0.25 * (linearMean ? light : encodeSRGB(light));
    }
    return linearMean ? encodeSRGB(mean) : mean;
}
