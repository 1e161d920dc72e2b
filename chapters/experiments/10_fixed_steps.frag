// Experiment of chapter 10: the chapter's ray is marched again, with steps of fixed length. The
// probe counts the evaluations of both marches together.
#include "main.glsl"
#define rayColour chapterRayColour
#include "10_distance_in_the_plane.frag"
#undef rayColour

// The chapter's colour. For the probe, a second march takes fixed steps to the first point inside
// the figure.
vec3 rayColour(Ray ray)
{
    vec3 colour = chapterRayColour(ray);
    float t = 0.0;
    while (VIEW == VIEW_PROBE && fixedStep > 0.0 && t < FAR && distanceAt(ray.origin + t * ray.direction) > 0.0)
        t += fixedStep;
    return colour;
}
