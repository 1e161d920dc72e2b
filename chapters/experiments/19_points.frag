// Experiment of chapter 19: stars that are as small as stars, not as wide as the pixel.
#include "main.glsl"
#include "night.glsl"

uniform float spot; // 0.2 in [0.05, 1] step *1.2, pixels: width that a star is spread over

vec3 pointLight(vec3 direction, float width)
{
    return starLight(direction, spot * width);
}

#define starLight pointLight
#include "19_moon_and_stars.frag"
