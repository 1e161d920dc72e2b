// Experiment of chapter 16: the workshop's castRay, as it is called second there. Its 64 steps end with a hit,
// also where nothing was found; and the count of its steps is divided as whole numbers are.
//
// The chapter's own rayColour is kept aside under another name; everything else is the chapter's.
#include "main.glsl"
#define rayColour chapterRayColour
#include "16_fewer_steps.frag"
#undef rayColour

uniform bool shares; // false: paint the share of the steps that were taken, in place of the scene
uniform bool mended; // false: steps that run out are no hit, and shares are divided as real numbers

const int STEPS = 64;

vec3 rayColour(Ray ray)
{
    float ground = ray.direction.y < 0.0 ? (SEA - ray.origin.y) / ray.direction.y : 1e6;
    Hit hit = march(ray, 0.0, min(ground, far), hitThreshold, STEPS);
    int steps = trace.steps;
    hit.found = hit.found || (!mended && steps == STEPS);
    float share = mended ? float(steps) / float(STEPS) : float(steps / STEPS);
    return shares ? vec3(share, 0.0, 0.0) : encodeSRGB(sceneLight(ray, hit, ground));
}
