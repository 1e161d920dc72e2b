// Experiment of chapter 01: a distance without its sign. Every solid becomes a sheet without
// thickness, and central differences across the sheet cancel.
//
// The chapter's sceneDistance is renamed; everything else is as in the chapter.
#include "main.glsl"
#define sceneDistance signedDistance
#include "01_normal_colouring.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    return abs(signedDistance(p));
}
