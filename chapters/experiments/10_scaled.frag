// Experiment of chapter 10: the figure, made smaller by evaluating it at a multiple of the point.
// Unless the distance is divided by the factor, it is too large, and a march steps through the
// figure.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "10_distance_in_the_plane.frag"
#undef sceneDistance

uniform float factor;  // 1.6 in [1, 4] step 0.1: how many times smaller the figure is
uniform bool  divided; // false: divide the distance by the factor

float sceneDistance(vec3 p)
{
    float d = chapterDistance(factor * p);
    return divided ? d / factor : d;
}
