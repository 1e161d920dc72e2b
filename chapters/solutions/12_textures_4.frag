// Solution to exercise 12.4: a circular footprint with the same area as the elliptical one. The
// picture becomes sharper, and sparkles more.
//
// The chapter's call to footprintOn is replaced by a call to roundFootprintOn.
#include "main.glsl"
#include "texture.glsl"

Footprint roundFootprintOn(vec3 direction, vec3 normal, float width)
{
    Footprint f = footprintOn(direction, normal, width);
    float radius = sqrt(length(f.across) * length(f.along));
    return Footprint(radius * normalize(f.across + vec3(1e-12)), radius * normalize(f.along + vec3(1e-12)));
}

#define footprintOn roundFootprintOn
#include "12_textures.frag"
