// The methods of chapter 16 in the march of an earlier chapter. In a file that includes this one
// before the chapter, the chapter's own calls of march and marchCone become relaxed marches, and
// the first march of a pixel begins where the coarse pass ended.
//
// Shadow rays of shadow.glsl and cone.glsl remain as they are. The including file defines
// coarseMargin.
#include "cone.glsl"
#include "shadow.glsl"
#include "relaxed.glsl"
#include "coarse.glsl"

uniform float omega; // 1.2 in [1, 1.95] step 0.05, distances: length of a step; 1 is the plain march

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
