// Solution to exercise 16.2: the water is part of the distance and is not found with a division.
// The water lies in no box, so each ray is marched up to the far limit.
#include "main.glsl"
#define sceneDistance chapterDistance
#define rayColour chapterRayColour
#include "16_fewer_steps.frag"
#undef rayColour
#undef sceneDistance

float sceneDistance(vec3 p)
{
    return min(chapterDistance(p), p.y - SEA);
}

vec3 rayColour(Ray ray)
{
    bool now = (float(iPixel.x) + 0.5) / iResolution.x >= divider;
    poleStretch = now && along ? twistStretchAlong(TWIST, POLE_REACH, ray.direction) : poleStretch;
    float spread = now ? footprint * pixelSpread() : 0.0;
    marchRelaxed(ray, now ? coarseStart(ray) : 0.0, far, hitThreshold, spread, now ? omega : 1.0, maxSteps);
    return stepColour(trace.steps);
}
