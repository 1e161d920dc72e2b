// Solution to exercise 02.2: light that is too bright keeps its hue, because all three channels are
// divided by the largest.
//
// The macro turns the chapter's call to encodeSRGB into a call to keepHue.
#include "main.glsl"
#include "lighting.glsl"

vec3 keepHue(vec3 light)
{
    float largest = max(light.r, max(light.g, light.b));
    return encodeSRGB(light / max(1.0, largest));
}

#define encodeSRGB keepHue
#include "02_lighting.frag"
