// Chapter 18's picture under a sky by another method: way=1 is the article's text, 2 its shader,
// 3 the formula of chapter 09. With encoded=true the article's two colours are mixed as encoded
// numbers.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour
#include "experiments/18_ways.glsl"

vec3 rayColour(Ray ray)
{
    vec3 sun = sunNow();
    Surface surface = surfaceAlong(ray);
    vec3 sky = skyByWay(surface.leaves, sun, encoded) + tableSun(halo, surface.leaves, sun, radians(sunRadius));
    return developed(surfaceLight(surface, sky, sun), sun);
}
