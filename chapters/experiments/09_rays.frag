// Experiment of chapter 09: the report's sky as its text says (section 3.4): green and blue times the
// scalar product with the direction of the sun's rays. The rays come down, so by day it is negative.
//
// The chapter's own rayColour is kept aside under another name; everything else is the chapter's.
#include "main.glsl"
#define rayColour chapterRayColour
#include "09_sky_and_sunset.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);
    float product = dot(vec3(0.0, 1.0, 0.0), -sun); // up, and the way that the light goes
    return cityColour(ray, sun, vec3(0.5, 0.7, 1.0) * vec3(1.0, product, product));
}
