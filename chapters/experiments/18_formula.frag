// Chapter 18's picture under the sky of chapter 09: a formula instead of the tables.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 sun = sunNow();
    Surface surface = surfaceAlong(ray);
    vec3 sky = 0.8 * (sunlitSky(surface.leaves, sun, RAYLEIGH + 0.05) + nightSky(surface.leaves, sun));
    sky += tableSun(halo, surface.leaves, sun, radians(sunRadius));
    return developed(surfaceLight(surface, sky, sun), sun);
}
