// Experiment of chapter 12: the workshop's projection along three axes. The pictures are weighted
// with |normal|, whose components add up to 1 where a surface faces along an axis and to 1.73 where
// it faces along a diagonal. Switch on the parameter `divided` to correct the weights.
//
// The library is included first, so that the macro replaces only the chapter's call.
#include "main.glsl"
#include "texture.glsl"

uniform bool divided; // false: divide the weights by their sum

vec3 workshopWeights(vec3 normal)
{
    vec3 w = abs(normal);
    return divided ? w / (w.x + w.y + w.z) : w;
}

#define planeWeights(normal, sharpness) workshopWeights(normal)
#include "12_textures.frag"
