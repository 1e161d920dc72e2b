// Solution to exercise 15.3: the film's curve is applied to the luminance.
#include "main.glsl"
#define rayColour chapterRayColour
#include "15_the_picture.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 light = lightOnFilm(ray);
    float luminance = max(dot(light, vec3(0.2126, 0.7152, 0.0722)), 1e-6);
    vec3 film = light * filmCurve(vec3(luminance), gamma, white).r / luminance;
    return contrast(encodeSRGB(film), punch) + (dither ? ditherStep(iPixel) / 255.0 : 0.0);
}
