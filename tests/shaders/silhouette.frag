// For tests/lib/measure.c: a ball of radius 1 at the origin, white on black.

#include "main.glsl"
#include "camera.glsl"
#include "march.glsl"
#include "primitives.glsl"

uniform int   maxSteps;     // 512 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.001 in [0.00001, 0.2], scene units: distance that counts as a hit

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    return sdSphere(p, 1.0);
}

vec3 rayColour(Ray ray)
{
    return vec3(march(ray, 0.0, 40.0, hitThreshold, maxSteps).found ? 1.0 : 0.0);
}
