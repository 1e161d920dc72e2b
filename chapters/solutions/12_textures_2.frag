// Solution to exercise 12.2: a threshold instead of a power. Below the threshold, the weight of a
// side is 0.
//
// The chapter's call to planeWeights is replaced by a call to thresholdWeights.
#include "main.glsl"
#include "texture.glsl"

uniform float threshold; // 0.5 in [0, 0.57] step 0.01: a side's weight is |normal| minus the threshold

vec3 thresholdWeights(vec3 normal, float sharpness)
{
    vec3 w = max(abs(normal) - threshold, 0.0);
    return w / (w.x + w.y + w.z);
}

#define planeWeights thresholdWeights
#include "12_textures.frag"
