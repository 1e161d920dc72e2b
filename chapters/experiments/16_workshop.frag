// Experiment of chapter 16: the workshop's castRay in its second form, with the 64 steps of the
// first. When the steps run out, castRay reports a hit, even where nothing was found; and it
// divides the number of steps as an integer.
//
// The chapter's rayColour is renamed; everything else is as in the chapter.
#include "main.glsl"
#define rayColour chapterRayColour
#include "16_fewer_steps.frag"
#undef rayColour

uniform bool shares; // false: paint the share of the steps that were taken instead of the scene
uniform bool mended; // false: a ray whose steps run out is a miss, and shares are quotients of real numbers

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
