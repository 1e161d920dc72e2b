// Experiment of chapter 01: a floor without end, and the rays that are given up under its horizon.
//
// The chapter's own sceneDistance is kept aside under another name; everything else is the chapter's.
#include "main.glsl"
#define sceneDistance sceneWithoutFloor
#include "01_normal_colouring.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    float ground = sdPlane(p, vec3(0.0, 1.0, 0.0), -0.8);
    return min(sceneWithoutFloor(p), ground);
}
