// Solution to exercise 17.2: a bubble of air in the ball. The larger of two distances is exact
// inside.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "17_glass.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    return opSubtraction(chapterDistance(p), sdSphere(p - BALL.xyz, 0.25));
}
