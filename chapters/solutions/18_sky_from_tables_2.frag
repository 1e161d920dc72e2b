// Solution to exercise 18.2: an eclipse. The moon is a little above the sun, and hides the part of
// the sun and of its halo that is behind it.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour

uniform float moonRadius; // 0.259 in [0.1, 5] step 0.1, degrees: radius of the moon; the article's is 1.7
uniform float apart;      // 0.1 in [-3, 3] step 0.05, degrees: height of the moon above the sun

vec3 rayColour(Ray ray)
{
    vec3 sun = sunNow();
    Surface surface = surfaceAlong(ray);
    vec3 up = normalize(vec3(0.0, 1.0, 0.0) - sun.y * sun);
    vec3 moon = cos(radians(apart)) * sun + sin(radians(apart)) * up;
    float hidden = disc(surface.leaves, moon, radians(moonRadius));
    vec3 sky = tableSky(sunward, away, surface.leaves, sun);
    sky += (1.0 - hidden) * tableSun(halo, surface.leaves, sun, radians(sunRadius));
    return developed(surfaceLight(surface, sky, sun), sun);
}
