// Solution to exercise 18.3: a painted sky. painted_sky.png has two storeys: the lower one is for
// the half of the sky that contains the sun, and the upper one is for the other half. In each, the
// sine of the sun's height increases to the right, from -1 to 1, and the sine of the direction's
// height increases upwards, from 0 to 1.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour

uniform sampler2D painted; // "painted_sky.png" sRGB clamp: the colours as the screen should show them

const float SIDE = 64.0; // columns, and rows of a storey

vec3 paintedColour(float sun, float direction, float storey)
{
    vec2 texel = 0.5 + (SIDE - 1.0) * vec2(0.5 + 0.5 * sun, max(direction, 0.0));
    return textureLod(painted, vec2(texel.x, texel.y + storey * SIDE) / vec2(SIDE, 2.0 * SIDE), 0.0).rgb;
}

vec3 rayColour(Ray ray)
{
    vec3 sun = sunNow();
    Surface surface = surfaceAlong(ray);
    vec3 d = surface.leaves;
    float a = dot(d.xz, sun.xz) / max(length(d.xz) * length(sun.xz), 1e-6);
    // The paint is the final colour: find the light that the exposure turns into it.
    vec3 light = mix(paintedColour(sun.y, d.y, 1.0), paintedColour(sun.y, d.y, 0.0), 0.5 + 0.5 * a);
    light = exposed(light, -stopsNow(sun));
    return developed(surfaceLight(surface, light, sun), sun);
}
