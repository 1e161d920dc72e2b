// Experiment of chapter 15: a night sky, in which each band of equal values covers about a twelfth
// of the picture's height. The colours of the sky are rounded to 255 steps here, with or without
// the dither, and then made brighter, so that the steps are visible.
#include "main.glsl"
#include "film.glsl"
#include "lighting.glsl"

uniform bool  dither;    // false: a fixed pattern before the rounding
uniform float brighter;  // 4 in [1, 8] step 0.5: factor for the rounded numbers

Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0));
}

float sceneDistance(vec3 p)
{
    return p.z;
}

vec3 rayColour(Ray ray)
{
    float up = 0.5 + 0.5 * ray.origin.y + 0.06 * ray.origin.x;
    vec3 sky = encodeSRGB(mix(vec3(0.0042, 0.0046, 0.0075), vec3(0.0005, 0.0008, 0.0028), up));
    return brighter * floor(255.0 * sky + (dither ? ditherStep(iPixel) : 0.0) + 0.5) / 255.0;
}
