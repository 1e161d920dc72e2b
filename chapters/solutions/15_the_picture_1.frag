// Solution to exercise 15.1: three exposures side by side, one stop apart.
#include "main.glsl"
#define rayColour chapterRayColour
#include "15_the_picture.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    float strip = floor(3.0 * (float(iPixel.x) + 0.5) / iResolution.x); // 0, 1, 2
    vec3 light = exposed(lightOnFilm(ray), strip - 1.0);
    return contrast(encodeSRGB(developed(light)), punch) + (dither ? ditherStep(iPixel) / 255.0 : 0.0);
}
