// Solution to exercise 05.2: the ball is a lens, flattened along one of its axes by a linear map.
// The code applies the inverse M of this map to the point, and divides the distance by the largest
// stretch of M.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "05_transforms.frag"
#undef sceneDistance

uniform float flatness; // 0.5 in [0.2, 1] step 0.05: ratio of the ball's height to its width
uniform bool  divided;  // true: divide by the largest stretch

float sceneDistance(vec3 p)
{
    mat3 m = mat3(1.0, 0.0, 0.0, 0.0, 1.0 / flatness, 0.0, 0.0, 0.0, 1.0);
    float ball = sdSphere(m * seenFrom(now.ball, p), 0.62);
    float lens = divided ? ball / largestStretch(m) : ball;
    float crate = sdBox(seenFrom(now.crate, p), vec3(0.42)) - 0.02;
    return stepScale * min(min(seaDistance(p), ringDistance(p)), min(lens, crate));
}
