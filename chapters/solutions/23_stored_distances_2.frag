// Solution to exercise 23.2: half of a hollow elephant.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "23_stored_distances.frag"
#undef sceneDistance

const float WALL = 0.07; // thickness of the shell, scene units

float sceneDistance(vec3 p)
{
    vec3 q = onTurntable(p);
    float value = storedDistance(grid, q);
    float shell = storedStep(max(value, -value - WALL));
    return min(max(shell, -q.x), turntableDistance(p));
}
