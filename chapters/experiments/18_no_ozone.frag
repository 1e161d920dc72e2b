// Chapter 18's picture with air that contains no ozone. The tables contain a quarter of the light,
// because without ozone an evening has up to three times as much light.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour

uniform sampler2D greySunward; // "no_ozone_sunward.png" sRGB clamp: the half of the sky that contains the sun
uniform sampler2D greyAway;    // "no_ozone_away.png" sRGB clamp: the other half

vec3 rayColour(Ray ray)
{
    vec3 sun = sunNow();
    Surface surface = surfaceAlong(ray);
    vec3 sky = 4.0 * tableSky(greySunward, greyAway, surface.leaves, sun) + darkSky(surface.leaves, sun);
    sky += tableSun(halo, surface.leaves, sun, radians(sunRadius));
    return developed(surfaceLight(surface, sky, sun), sun);
}
