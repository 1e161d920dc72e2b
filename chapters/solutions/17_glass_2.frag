// Solution to exercise 17.2: a bubble of air in the ball. Inside the glass, the larger of the two
// distances is exact.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "17_glass.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    return opSubtraction(chapterDistance(p), sdSphere(p - BALL.xyz, 0.25));
}
