// Experiment of chapter 14: the workshop's occlusion, 1 - steps / most. In the workshop's code,
// both numbers are integers, so the quotient is 0 except for rays that use up all their steps.
//
// The chapter's rayColour is renamed; everything else is as in the chapter.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

uniform int  most;     // 32 in [8, 512]: the number of steps at which the picture is black
uniform bool integers; // false: divide integers, as in the workshop's line

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface surface = courtyardSurface(ray, hitThreshold, most);
    int whole = trace.steps / most;
    float share = integers ? float(whole) : float(trace.steps) / float(most);
    vec3 light = surface.open ? skyLight(ray.direction) : (bare ? vec3(1.0) : surface.colour * SKY);
    return encodeSRGB((1.0 - min(share, 1.0)) * light);
}
