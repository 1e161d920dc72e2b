// Solution of exercise 01.6: steps that are a multiple of the distance.
//
// The chapter's own sceneDistance is kept aside under another name; everything else is the chapter's.
#include "main.glsl"
#define sceneDistance trueDistance
#include "01_normal_colouring.frag"
#undef sceneDistance

uniform float factor; // 1.5 in [0.25, 4] step *1.1, times the distance: length of a step

// Up to 1 a lower bound of the distance; above 1 not a bound, and rays pass through what is thin.
float sceneDistance(vec3 p)
{
    return factor * trueDistance(p);
}
