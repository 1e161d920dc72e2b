// Solution to exercise 01.6: steps that are a multiple of the distance.
//
// The chapter's sceneDistance is renamed; everything else is as in the chapter.
#include "main.glsl"
#define sceneDistance trueDistance
#include "01_normal_colouring.frag"
#undef sceneDistance

uniform float factor; // 1.5 in [0.25, 4] step *1.1, times the distance: length of a step

// For a factor of up to 1, the result is a lower bound of the distance. Above 1 it is not, and rays
// may pass through thin objects.
float sceneDistance(vec3 p)
{
    return factor * trueDistance(p);
}
