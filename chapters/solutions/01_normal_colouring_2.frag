// Solution to exercise 01.2: the frame has rounded edges and the same outer size.
//
// The chapter's sceneDistance is renamed; everything else is as in the chapter.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "01_normal_colouring.frag"
#undef sceneDistance

uniform float rounding; // 0.06 in [0, 0.08] step 0.01, scene units: radius of the frame's edges

float sceneDistance(vec3 p)
{
    float frame = sdBoxFrame(p, vec3(0.8 - rounding), 0.08 - rounding) - rounding;
    return min(frame, sdSphere(p, 0.52));
}
