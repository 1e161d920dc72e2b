// Experiment of chapter 10: the figure, made smaller by asking at a larger place. Unless the answer is made
// smaller too, it is too large by the factor, and a march steps through the figure.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "10_distance_in_the_plane.frag"
#undef sceneDistance

uniform float factor;  // 1.6 in [1, 4] step 0.1: the figure is so many times smaller
uniform bool  divided; // false: the distance too

float sceneDistance(vec3 p)
{
    float d = chapterDistance(factor * p);
    return divided ? d / factor : d;
}
