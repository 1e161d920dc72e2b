// Experiment of chapter 15: a vignette as the workshop describes it, which darkens a picture
// according to the distance from its centre, compared with cos^4. The workshop's vignette
// multiplies the encoded values, and does not depend on the lens.
#include "main.glsl"
#define rayColour chapterRayColour
#include "15_the_picture.frag"
#undef rayColour

uniform bool  lens;     // false: the light falls off as cos^4; otherwise the encoded values are darkened
uniform float strength; // 0.5 in [0, 1] step 0.05: how much the corners are darkened

vec3 rayColour(Ray ray)
{
    Seen seen = seenAlong(ray);
    vec2 screen = screenPosition(vec2(iPixel) + 0.5), corner = screenPosition(iResolution.xy);
    float painted = 1.0 - strength * dot(screen, screen) / dot(corner, corner);
    float share = lens ? cosineFourth(screen, focalLength) : 1.0;
    vec3 light = exposed(share * throughFog(seen.light, seen.fog, seen.depth), exposure);
    return (lens ? 1.0 : painted) * encodeSRGB(developed(light));
}
