// Experiment of chapter 16: bounding volumes inside the distance function. Far from the box around
// a group of objects, the distance to the box is enough, and an if skips the group's contents.
//
// The picture is the same as the chapter's. Whether it is drawn faster depends on the machine; to
// measure this, run build/tests/measure speed with the chapter's file and this one.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "16_fewer_steps.frag"
#undef sceneDistance

uniform float near; // 0.5 in [0.01, 100] step *2, scene units: below this distance to a box, its contents are evaluated

float boxed(vec3 p, vec3 low, vec3 high)
{
    return sdBox(p - 0.5 * (low + high), 0.5 * (high - low));
}

float sceneDistance(vec3 p)
{
    vec3 q = vec3(abs(p.x), p.yz);
    float pier = boxed(q, vec3(-1.6, -1.4, -41.0), vec3(1.6, 3.0, 7.9));
    float pavilion = boxed(q, vec3(-4.3, -0.2, -49.0), vec3(4.3, 7.1, -40.0));
    float poles = boxed(q, POLES_LOW, POLES_HIGH);
    if (pier < near)
        pier = pierDistance(q);
    if (pavilion < near)
        pavilion = pavilionDistance(q);
    if (poles < near)
        poles = polesDistance(q);
    return min(min(pier, pavilion), poles);
}
