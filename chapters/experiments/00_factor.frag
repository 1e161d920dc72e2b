// Experiment of chapter 00: the distance, times a factor. With 1 the picture is the chapter's; with more the
// march is told more than is true.
#include "main.glsl"
#include "march.glsl"
#include "normal.glsl"
#define sceneDistance trueDistance
#include "00_seen.frag"
#undef sceneDistance

uniform float factor; // 1 in [0.1, 2.5] step 0.1: what the march is told is the distance times this

float sceneDistance(vec3 p)
{
    return factor * trueDistance(p);
}
