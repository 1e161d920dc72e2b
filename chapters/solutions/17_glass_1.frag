// Solution to exercise 17.1: Schlick's share instead of Fresnel's. For a ray inside the glass,
// Schlick's formula needs the cosine of the angle at which the refracted ray leaves.
#include "main.glsl"
#include "glass.glsl"
#define partingAt schlickParting
Parting schlickParting(vec3 direction, vec3 normal, float side, float index);
#include "17_glass.frag"
#undef partingAt

float schlickBothSides(float facing, float eta)
{
    float root = (eta - 1.0) / (eta + 1.0), square = 1.0 - eta * eta * (1.0 - facing * facing);
    float outside = eta > 1.0 ? sqrt(max(square, 0.0)) : facing;
    return square > 0.0 ? schlickShare(outside, root * root) : 1.0;
}

Parting schlickParting(vec3 direction, vec3 normal, float side, float index)
{
    Parting parting = partingAt(direction, normal, side, index);
    float facing = clamp(-side * dot(normal, direction), 0.0, 1.0);
    parting.mirrored = schlickBothSides(facing, side > 0.0 ? 1.0 / index : index);
    return parting;
}
