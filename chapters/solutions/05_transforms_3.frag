// Solution to exercise 05.3: the ball has bumps. It is displaced by bumpHeight times a product of
// three sines; the slope of this displacement is at most bumpHeight times fineness.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "05_transforms.frag"
#undef sceneDistance

uniform float bumpHeight; // 0.03 in [0, 0.1] step 0.005, scene units: height of a bump
uniform float fineness;   // 16 in [1, 40] step 1, radians per scene unit: how close together the bumps are

float sceneDistance(vec3 p)
{
    vec3 q = seenFrom(now.ball, p), wave = sin(fineness * q);
    float bumps = bumpHeight * wave.x * wave.y * wave.z;
    float ball = (sdSphere(q, 0.62 - bumpHeight) + bumps) / displacementStretch(bumpHeight * fineness);
    float crate = sdBox(seenFrom(now.crate, p), vec3(0.42)) - 0.02;
    return stepScale * min(min(seaDistance(p), ringDistance(p)), min(ball, crate));
}
