// For tests/lib/occlusion.c: the visible share of the sky in the scene of chapter 14, from a formula (red) and from 576
// rays (blue); green is 0 where the picture shows the sky.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

uniform int formula; // 0 in [0, 4]: nothing hides, taps of strength 1/2, taps, near taps count more, 1 - steps / 32

// openByTaps with larger weights for the lower taps, as in the solution to exercise 14.1.
float nearTaps(Surface surface)
{
    float hidden = 0.0, sum = 0.0, weight = 1.0;
    for (int k = 0; k < TAPS; k++) {
        float height = tapHeight(k, reach);
        hidden += weight * clamp(1.0 - distanceAt(surface.p + height * surface.normal) / height, 0.0, 1.0);
        sum += weight;
        weight *= 0.5;
    }
    return 1.0 - hidden / sum;
}

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface surface = courtyardSurface(ray, hitThreshold, maxSteps);
    float steps = min(float(trace.steps) / 32.0, 1.0);
    lookingRound = true;
    float even = openByTaps(surface.p, surface.normal, reach, formula == 0 ? 0.0 : 0.5 * float(formula));
    float taps = formula == 3 ? nearTaps(surface) : even;
    float quick = formula == 4 ? 1.0 - steps : openOverGround(surface.normal) * taps;
    return vec3(quick, surface.open ? 0.0 : 1.0, openTruly(surface, surface.open ? 0 : 24));
}
