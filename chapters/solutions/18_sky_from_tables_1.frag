// Solution to exercise 18.1: the table as the article cited in docs/18_sky_from_tables.md draws it,
// on the side of the sun. The sine of the sun's height increases to the right, from -0.28 to 1, and
// the sine of the direction's height increases upwards, from 0 to 1. The sun is in the west, where
// the camera looks.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec2 at = (vec2(iPixel) + 0.5) / iResolution.xy;
    float s = mix(-0.28, 1.0, at.x);
    vec3 sun = vec3(0.0, s, -sqrt(1.0 - s * s)), direction = vec3(0.0, at.y, -sqrt(1.0 - at.y * at.y));
    return developed(tableSky(sunward, away, direction, sun), sun);
}
