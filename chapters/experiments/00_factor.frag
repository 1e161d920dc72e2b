// Experiment of chapter 00: the distance times a factor. With a factor of 1 the picture is the
// chapter's; with a larger factor the march uses more than the distance.
#include "main.glsl"
#include "march.glsl"
#include "normal.glsl"
#define sceneDistance trueDistance
#include "00_seen.frag"
#undef sceneDistance

uniform float factor; // 1 in [0.1, 2.5] step 0.1: the march uses the distance times this

float sceneDistance(vec3 p)
{
    return factor * trueDistance(p);
}
