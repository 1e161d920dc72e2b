// Experiment of chapter 19: stars drawn as small points, narrower than a pixel.
#include "main.glsl"
#include "night.glsl"

uniform float spot; // 0.2 in [0.05, 1] step *1.2, pixels: width over which a star is spread

vec3 pointLight(vec3 direction, float width)
{
    return starLight(direction, spot * width);
}

#define starLight pointLight
#include "19_moon_and_stars.frag"
