// Solution to exercise 05.2: the ball is a lens, flattened along one of its axes by a linear map.
// The code applies the inverse M of this map to the point, and divides the distance by the largest
// stretch of M.
//
// A macro replaces the chapter's call of sdSphere, so the foam follows the lens as the march does.
#include "main.glsl"
#include "primitives.glsl"
float lensDistance(vec3 fromMiddle, float radius); // defined below, where the chapter's functions are known
#define sdSphere lensDistance
#include "05_transforms.frag"
#undef sdSphere

uniform float flatness; // 0.5 in [0.2, 1] step 0.05: ratio of the ball's height to its width
uniform bool  divided;  // true: divide by the largest stretch

float lensDistance(vec3 fromMiddle, float radius)
{
    mat3 m = mat3(1.0, 0.0, 0.0, 0.0, 1.0 / flatness, 0.0, 0.0, 0.0, 1.0);
    float ball = sdSphere(m * seenFrom(now.ball, now.ball.position + fromMiddle), radius);
    return divided ? ball / largestStretch(m) : ball;
}
