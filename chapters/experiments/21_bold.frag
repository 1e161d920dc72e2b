// Experiment of chapter 21: steps of `bold` times the distance, as if the land were less steep than
// proved.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "21_a_landscape.frag"
#undef sceneDistance

uniform float bold; // 3 in [0.5, 12] step 0.5: length of a step, in proved distances

float sceneDistance(vec3 p)
{
    return bold * chapterDistance(p);
}
