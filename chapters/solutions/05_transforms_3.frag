// Solution to exercise 05.3: the ball has bumps. It is displaced by bumpHeight times a product of
// three sines; the slope of this displacement is at most bumpHeight times fineness.
//
// A macro replaces the chapter's call of sdSphere, so the foam follows the bumps as the march does.
#include "main.glsl"
#include "primitives.glsl"
float bumpyDistance(vec3 fromMiddle, float radius); // defined below, where the chapter's functions are known
#define sdSphere bumpyDistance
#include "05_transforms.frag"
#undef sdSphere

uniform float bumpHeight; // 0.03 in [0, 0.1] step 0.005, scene units: height of a bump
uniform float fineness;   // 16 in [1, 40] step 1, radians per scene unit: how close together the bumps are

float bumpyDistance(vec3 fromMiddle, float radius)
{
    vec3 q = seenFrom(now.ball, now.ball.position + fromMiddle), wave = sin(fineness * q);
    float bumps = bumpHeight * wave.x * wave.y * wave.z;
    return (sdSphere(q, radius - bumpHeight) + bumps) / displacementStretch(bumpHeight * fineness);
}
