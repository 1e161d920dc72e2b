// Experiment of chapter 15: the workshop's contrast, smoothstep(0, 1, colour), applied to the light
// or to the encoded values. The film's curve is left out, because it also raises the contrast.
#include "main.glsl"
#define rayColour chapterRayColour
#include "15_the_picture.frag"
#undef rayColour

uniform bool before; // false: apply the contrast to the light, before it is encoded

vec3 rayColour(Ray ray)
{
    vec3 light = lightOnFilm(ray);
    return before ? encodeSRGB(contrast(light, 1.0)) : contrast(encodeSRGB(light), 1.0);
}
