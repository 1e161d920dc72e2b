// Solution of exercise 17.1: Schlick's share in place of Fresnel's. Inside it wants the cosine behind the surface.
#include "main.glsl"
#include "glass.glsl"   // its shadows keep Fresnel's share,
#include "caustic.glsl" // and its caustic
#define fresnelShare schlickBothSides
float schlickBothSides(float facing, float eta);
#include "17_glass.frag"
#undef fresnelShare

float schlickBothSides(float facing, float eta)
{
    float root = (eta - 1.0) / (eta + 1.0), square = 1.0 - eta * eta * (1.0 - facing * facing);
    float outside = eta > 1.0 ? sqrt(max(square, 0.0)) : facing;
    return square > 0.0 ? schlickShare(outside, root * root) : 1.0;
}
