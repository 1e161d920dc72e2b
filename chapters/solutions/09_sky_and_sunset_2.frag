// Solution to exercise 09.2: a sky of one colour, reddened in the same way as the light of the sun:
// (0.5, 0.7, 1) times the transmittance of the air beyond one air mass.
#include "main.glsl"
#define rayColour chapterRayColour
#include "09_sky_and_sunset.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);
    vec3 reddened = vec3(0.5, 0.7, 1.0) * transmittance(RAYLEIGH, airMass(sun.y) - 1.0);
    return cityColour(ray, sun, daylight(sun.y) * reddened);
}
