// Experiment of chapter 13: where one march is wrong. The picture is blue where the shadow from one
// march is darker than the estimate from 64 rays, and orange where it is lighter. Where the two
// agree, the picture shows the scene in grey.
//
// The chapter's rayColour is renamed; everything else is as in the chapter.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour

const vec3 DARKER = vec3(0.03, 0.16, 0.50), LIGHTER = vec3(0.85, 0.32, 0.02); // colours of large errors

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface surface = surfaceAt(ray);
    Ray there = sunRay(surface, toSun);
    float truth = lampReaching(there, sunReach(surface, there), spread, 8, hitThreshold, maxSteps, 1000);
    float off = sunSeen(surface, toSun) - truth;
    float shade = dot(surfaceLight(surface, ray, toSun, 1.0), vec3(0.25));
    vec3 ground = vec3(surface.open ? 0.9 : 0.45 + 0.45 * shade);
    return encodeSRGB(mix(ground, off < 0.0 ? DARKER : LIGHTER, min(1.5 * abs(off), 1.0)));
}
