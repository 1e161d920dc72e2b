// Experiment of chapter 15: a vignette as the workshop describes it, a picture darkened by the distance from its
// middle, beside cos^4. It multiplies the numbers of the screen, and knows no lens.
#include "main.glsl"
#define rayColour chapterRayColour
#include "15_the_picture.frag"
#undef rayColour

uniform bool  lens;     // false: the light falls off as cos^4, true; the numbers are darkened, false
uniform float strength; // 0.5 in [0, 1] step 0.05: how much is taken in the corners

vec3 rayColour(Ray ray)
{
    Seen seen = seenAlong(ray);
    vec2 screen = screenPosition(vec2(iPixel) + 0.5), corner = screenPosition(iResolution.xy);
    float painted = 1.0 - strength * dot(screen, screen) / dot(corner, corner);
    float share = lens ? cosineFourth(screen, focalLength) : 1.0;
    vec3 light = exposed(share * throughFog(seen.light, seen.fog, seen.depth), exposure);
    return (lens ? 1.0 : painted) * encodeSRGB(developed(light));
}
