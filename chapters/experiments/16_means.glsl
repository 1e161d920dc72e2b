// The means of chapter 16 in the march of an older chapter: a file that includes this one before the chapter
// has its marches relaxed, and its first one begin where the coarse pass has ended.
//
// Shadow rays of shadow.glsl and cone.glsl stay as they are. The file itself says what coarseMargin is.
#include "cone.glsl"
#include "shadow.glsl"
#include "relaxed.glsl"
#include "coarse.glsl"

uniform float omega; // 1.2 in [1, 1.95] step 0.05, distances: length of a step; 1 is the march as it was

Hit meansCone(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    float start = trace.marches == 0 ? max(tMin, coarseStart(ray)) : tMin;
    return marchRelaxed(ray, start, tMax, threshold, spread, omega, maxSteps);
}

Hit meansMarch(Ray ray, float tMin, float tMax, float threshold, int maxSteps)
{
    return meansCone(ray, tMin, tMax, threshold, 0.0, maxSteps);
}

#define march meansMarch
#define marchCone meansCone
