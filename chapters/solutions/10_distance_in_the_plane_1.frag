// Solution to exercise 10.1: four rings from one disc. Each opOnion turns every edge into two.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "10_distance_in_the_plane.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    float disc = sdCircle(p.xy, 0.6);
    return opOnion(opOnion(opOnion(disc, 0.28), 0.14), 0.05);
}
