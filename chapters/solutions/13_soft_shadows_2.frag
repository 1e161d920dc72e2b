// Solution to exercise 13.2: only the ball's shadow, in closed form and without any march.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface surface = surfaceAt(ray);
    Ray there = sunRay(surface, toSun);
    vec3 toBall = BALL.xyz - there.origin;
    bool before = dot(toBall, toSun) > 0.0; // true on the ball's dark side too, where Lambert's cosine is 0 anyway
    float behind = lampBesideBall(there.origin, toSun, spread, BALL.xyz, BALL.w);
    return encodeSRGB(surfaceLight(surface, ray, toSun, before ? behind : 1.0));
}
