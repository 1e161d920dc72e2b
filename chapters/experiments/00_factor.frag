// Experiment of chapter 00: the distance times a factor. With a factor of 1, the picture is the
// same as the chapter's; with a larger factor, each step of the march is longer than the distance.
#include "main.glsl"
#include "march.glsl"
#include "normal.glsl"
#define sceneDistance trueDistance
#include "00_seen.frag"
#undef sceneDistance

uniform float factor; // 1 in [0.1, 2.5] step 0.1, times the distance: length of each step

float sceneDistance(vec3 p)
{
    return factor * trueDistance(p);
}
