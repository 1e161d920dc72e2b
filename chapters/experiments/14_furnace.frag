// Experiment of chapter 14: the white furnace. Everything is white and reflects all the light that
// it receives, under a sky whose light is 1. Everything must then look as bright as the sky, so
// nothing should be visible. Blue is too dark; orange, drawn three times as strong, is too light.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

uniform int sum; // 2 in [0, 3]: 0 only the sky, 1 with one bounce, 2 with all bounces, 3 like 1, with the light of the ground added again

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface surface = courtyardSurface(ray, hitThreshold, maxSteps);
    lookingRound = true;
    float open = openQuickly(surface);
    float light = skyAndBounces(open, vec3(1.0), min(sum, 2)).x;
    light = sum == 3 ? open * (2.0 - open) + 1.0 - openOverGround(surface.normal) : light;
    float off = surface.open ? 0.0 : light - 1.0;
    return encodeSRGB(mix(vec3(0.9), off < 0.0 ? DARKER : LIGHTER, min(max(-off, 3.0 * off), 1.0)));
}
