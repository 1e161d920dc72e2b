// Experiment of chapter 12: the workshop's three planes. It weights the three pictures with |normal|, whose
// parts add up to 1 on a face and to 1.73 where a surface looks at a corner of the world. Set divided to
// mend it.
//
// The library is included first, so that the macro meets the chapter's call and nothing else.
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
