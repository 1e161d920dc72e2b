// Solution to exercise 10.4: a lamp at the start of the chapter's ray. Points that the lamp's light
// does not reach are in shadow.
#include "main.glsl"
#define rayColour chapterRayColour
#include "10_distance_in_the_plane.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 colour = chapterRayColour(ray);
    vec2 way = planePoint(screenPosition(gl_FragCoord.xy + iPixelOffset)) - rayStart;
    float away = length(way);
    Ray toPoint = Ray(vec3(rayStart, 0.0), vec3(way / max(away, 1e-6), 0.0));
    return march(toPoint, 0.0, away, hitThreshold, maxSteps).found ? 0.6 * colour : colour;
}
