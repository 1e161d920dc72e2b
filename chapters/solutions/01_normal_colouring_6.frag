// Solution to exercise 01.6: steps that are a multiple of the distance.
//
// The chapter's own sceneDistance gets another name; everything else is the chapter's.
#include "main.glsl"
#define sceneDistance trueDistance
#include "01_normal_colouring.frag"
#undef sceneDistance

uniform float factor; // 1.5 in [0.25, 4] step *1.1, times the distance: length of a step

// For a factor up to 1, a lower bound of the distance. Above 1 it is no bound, and rays pass
// through thin objects.
float sceneDistance(vec3 p)
{
    return factor * trueDistance(p);
}
