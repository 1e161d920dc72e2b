// Experiment of chapter 13: soft shadows as in the workshop's listing. The listing draws one random number per pixel,
// not one per ray, so that all rays of a pixel are the same; it shifts the ray only along the diagonal (1, 1, 1); it
// does not normalise the direction; and it darkens all the light. The parameters correct all of these mistakes except
// the shift along the diagonal.
//
// The workshop's random number comes from a sine, which differs from driver to driver. Here it comes from pixelRandom.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour

uniform float falloff;  // 0.04 in [0, 0.5] step 0.02: how far the ray is shifted, the workshop's SHADOW_FALLOFF
uniform bool  eachRay;  // false: each ray has its own random number
uniform bool  unit;     // false: normalise the directions
uniform bool  sunAlone; // false: the shadow darkens only the sun's light, not the ambient light

// The share of the rays that reach the sun.
float workshopReaching(Ray ray, float far)
{
    float arrived = 0.0;
    for (int i = 0; i < rays * rays; i++) {
        float r = 2.0 * pixelRandom(eachRay ? i : 0) - 1.0;
        vec3 direction = ray.direction + falloff * r * vec3(1.0);
        direction = unit ? normalize(direction) : direction;
        arrived += lightReaching(Ray(ray.origin, direction), far, hitThreshold, maxSteps);
    }
    return arrived / float(rays * rays);
}

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface surface = surfaceAt(ray);
    Ray there = sunRay(surface, toSun);
    float seen = workshopReaching(there, sunReach(surface, there));
    float whole = surface.open || sunAlone ? 1.0 : mix(0.2, 1.0, seen);
    return encodeSRGB(whole * surfaceLight(surface, ray, toSun, sunAlone ? seen : 1.0));
}
