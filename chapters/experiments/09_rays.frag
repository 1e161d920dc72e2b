// Experiment of chapter 09: the report's sky as its text describes it (section 3.4): green and blue
// are multiplied by the scalar product of the upward direction and the direction of the sun's rays.
// The rays point down, so by day the product is negative.
//
// The chapter's rayColour is renamed; everything else is as in the chapter.
#include "main.glsl"
#define rayColour chapterRayColour
#include "09_sky_and_sunset.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);
    float product = dot(vec3(0.0, 1.0, 0.0), -sun); // up, and the direction of the rays
    return cityColour(ray, sun, vec3(0.5, 0.7, 1.0) * vec3(1.0, product, product));
}
