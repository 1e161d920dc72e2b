// Exercise 18.1: the table as the article draws it: to the right the sine of the sun's height, from -0.28 to 1, upwards
// that of the direction's, from 0 to 1, on the sun's side.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec2 at = (vec2(iPixel) + 0.5) / iResolution.xy;
    float s = mix(-0.28, 1.0, at.x);
    vec3 sun = vec3(sqrt(1.0 - s * s), s, 0.0), direction = vec3(sqrt(1.0 - at.y * at.y), at.y, 0.0);
    return developed(tableSky(sunward, away, direction, sun), sun);
}
