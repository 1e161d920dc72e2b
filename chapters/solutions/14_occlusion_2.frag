// Solution to exercise 14.2: only the two box trees hide part of the sky; the share that each of
// them hides is computed in closed form.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface surface = courtyardSurface(ray, hitThreshold, maxSteps);
    vec3 start = surface.p + 2.0 * surface.radius * surface.normal;
    float large = hiddenByBall(start, surface.normal, COURT_BALL.xyz, COURT_BALL.w);
    float small = hiddenByBall(start, surface.normal, COURT_SMALL_BALL.xyz, COURT_SMALL_BALL.w);
    bool green = boxTreeDistance(surface.p) < surface.radius;
    float open = green ? 1.0 : openOverGround(surface.normal) * (1.0 - large) * (1.0 - small);
    return encodeSRGB(surface.open ? skyLight(ray.direction) : surfaceLight(surface, open));
}
