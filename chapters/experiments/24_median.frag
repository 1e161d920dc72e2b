// Experiment of chapter 24: each pixel shows the one in the middle, by brightness, of the 3 x 3 pixels around it.
#include "main.glsl"
#define rayColour chapterRayColour
#include "24_bounces.frag"
#undef rayColour

vec3 keptNear(ivec2 off)
{
    return texelFetch(history, clamp(iPixel + off, ivec2(0), ivec2(iResolution.xy) - 1), 0).rgb;
}

vec3 rayColour(Ray ray)
{
    roomSurface(ray, hitThreshold, maxSteps); // for the views
    vec3 middle = vec3(0.0);
    for (int i = 0; i < 9; i++) {
        vec3 light = keptNear(ivec2(i % 3, i / 3) - 1);
        int darker = 0;
        for (int k = 0; k < 9; k++) {
            float other = dot(keptNear(ivec2(k % 3, k / 3) - 1), vec3(1.0)), here = dot(light, vec3(1.0));
            darker += other < here || (other == here && k < i) ? 1 : 0;
        }
        middle = darker == 4 ? light : middle;
    }
    return encodeSRGB(filmCurve(exposed(middle, exposure), 1.25, 9.0));
}
