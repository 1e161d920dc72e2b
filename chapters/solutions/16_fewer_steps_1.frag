// Solution to exercise 16.1: where the coarse pass lets the rays begin, in grey; white is 30 scene
// units or more.
#include "main.glsl"
#define rayColour chapterRayColour
#include "16_fewer_steps.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    return vec3(min(coarseStart(ray) / 30.0, 1.0));
}
