// Experiment of chapter 10: the chapter's ray once more, by steps of one length. The numbers of the probe hold
// what both marches asked.
#include "main.glsl"
#define rayColour chapterRayColour
#include "10_distance_in_the_plane.frag"
#undef rayColour

// Up to the first place that is inside.
vec3 rayColour(Ray ray)
{
    vec3 colour = chapterRayColour(ray);
    float t = 0.0;
    while (VIEW == 6 && fixedStep > 0.0 && t < FAR && distanceAt(ray.origin + t * ray.direction) > 0.0)
        t += fixedStep;
    return colour;
}
