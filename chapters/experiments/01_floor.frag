// Experiment of chapter 01: an endless floor, and the rays that are abandoned below its horizon.
//
// The chapter's sceneDistance is renamed; everything else is as in the chapter.
#include "main.glsl"
#define sceneDistance sceneWithoutFloor
#include "01_normal_colouring.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    float ground = sdPlane(p, vec3(0.0, 1.0, 0.0), -0.8);
    return min(sceneWithoutFloor(p), ground);
}
