// Experiment of chapter 17: a ball glued together from two halves that touch. The union of their
// distances is 0 where the halves meet, so the march inside finds a surface there that does not
// exist.
//
// The chapter's sceneDistance is renamed; everything else is as in the chapter.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "17_glass.frag"
#undef sceneDistance

uniform float overlap; // 0 in [0, 0.2] step 0.01, scene units: how far each half extends into the other

float sceneDistance(vec3 p)
{
    float ball = ballDistance(p), cut = dot(p - BALL.xyz, vec3(-0.6, 0.64, 0.48));
    float halves = min(max(ball, cut - overlap), max(ball, -cut - overlap));
    return min(tumblerDistance(p), min(prismDistance(p), halves));
}
