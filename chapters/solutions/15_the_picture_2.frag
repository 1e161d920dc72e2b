// Solution to exercise 15.2: a uniform layer of fog up to the height fogScale, and clear air above
// it.
#include "main.glsl"
#define rayColour chapterRayColour
#include "15_the_picture.frag"
#undef rayColour

// The length of a path inside the layer: the part before the ray crosses the layer's top if the ray
// climbs, or the part after that if it descends.
//   height, climb, t  as for fogDepth
float inLayer(float height, float climb, float t)
{
    climb = abs(climb) < 1e-6 ? 1e-6 : climb;   // a level ray is treated as climbing a little
    float top = (fogScale - height) / climb;    // where the ray crosses the layer's top
    float crossed = clamp(top, 0.0, t);
    return climb > 0.0 ? crossed : t - crossed;
}

vec3 rayColour(Ray ray)
{
    Seen seen = seenAlong(ray);
    float depth = fogDensity * inLayer(ray.origin.y, ray.direction.y, seen.way);
    float share = vignette ? cosineFourth(screenPosition(vec2(iPixel) + 0.5), focalLength) : 1.0;
    vec3 light = exposed(share * throughFog(seen.light, seen.fog, depth), exposure);
    return contrast(encodeSRGB(developed(light)), punch) + (dither ? ditherStep(iPixel) / 255.0 : 0.0);
}
