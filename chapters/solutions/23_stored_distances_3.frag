// Solution to exercise 23.3: halfway between the elephant and a ball.
#include "main.glsl"
#include "primitives.glsl"
#define sceneDistance chapterDistance
#include "23_stored_distances.frag"
#undef sceneDistance

uniform float share; // 0.5 in [0, 1] step 0.05: 0 the elephant, 1 a ball of radius 0.5

// The elephant's distance is 1.733-Lipschitz, and the ball's is 1-Lipschitz and exact.
float sceneDistance(vec3 p)
{
    float value = mix(storedDistance(grid, onTurntable(p)), sdSphere(p, 0.5), share);
    float least = abs(value) / mix(1.733, 1.0, share);
    float far = abs(value) - (1.0 - share) * 1.733 * STORED_CELL;
    return min(sign(value) * max(least, far), turntableDistance(p));
}
