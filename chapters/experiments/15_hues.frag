// Experiment of chapter 15: what three curves do to six colours with increasing exposure. The rows
// are six hues, and the exposure increases by eight stops from left to right, from dark to
// dazzling. Each row has three strips: clamped, the film's curve on each channel, and the film's
// curve on the largest channel.
#include "main.glsl"
#include "film.glsl"
#include "hue.glsl"
#include "lighting.glsl"

uniform float gamma; // 1.45 in [1, 3] step 0.05: steepness of the film's curve
uniform float white; // 8 in [1.5, 64] step *1.1: the light that becomes white

Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0));
}

float sceneDistance(vec3 p)
{
    return p.z;
}

vec3 rayColour(Ray ray)
{
    vec2 uv = 0.5 + 0.5 * ray.origin.xy / vec2(iResolution.x / iResolution.y, 1.0);
    float row = 6.0 * (1.0 - uv.y), strip = 3.0 * fract(row);
    vec3 hue = mix(vec3(0.06), vec3(0.9), hueToRGB(25.0 + 60.0 * floor(row)));
    vec3 light = exposed(hue, 8.0 * uv.x - 4.0);
    vec3 film = strip < 2.0 ? filmCurve(light, gamma, white) : filmOfLargest(light, gamma, white);
    float gap = min(fract(row), 1.0 - fract(row));
    return encodeSRGB(gap < 0.03 ? vec3(0.02) : (strip < 1.0 ? light : film));
}
