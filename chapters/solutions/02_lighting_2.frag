// Solution of exercise 02.2: too much light keeps its hue, because all three channels are divided by
// the largest of them.
//
// The chapter's call of encodeSRGB is turned into a call of keepHue; everything else is the chapter's.
#include "main.glsl"
#include "lighting.glsl"

vec3 keepHue(vec3 light)
{
    float largest = max(light.r, max(light.g, light.b));
    return encodeSRGB(light / max(1.0, largest));
}

#define encodeSRGB keepHue
#include "02_lighting.frag"
