// Solution to exercise 08.5: empty cubes instead of empty balls. The scene's distance f consists
// only of maxima, minima and coordinates, so the cube of half side f around a point is empty too,
// and a ray leaves it only after f / max(|d.x|, |d.y|, |d.z|).
#include "main.glsl"
#include "march.glsl"
#include "shadow.glsl" // included before march is renamed, so shadow rays still use balls
#define march marchCubes
#define sceneDistance chapterDistance

float stretch = 0.0; // factor on the steps of the current ray; 0 outside marchCubes

float chapterDistance(vec3 p);
Hit   marchCubes(Ray ray, float tMin, float tMax, float threshold, int maxSteps);

#include "08_orthographic_view.frag"
#undef march
#undef sceneDistance

float sceneDistance(vec3 p)
{
    return (stretch > 0.0 ? stretch : 1.0) * chapterDistance(p);
}

Hit marchCubes(Ray ray, float tMin, float tMax, float threshold, int maxSteps)
{
    vec3 d = abs(ray.direction);
    stretch = 1.0 / max(d.x, max(d.y, d.z));
    Hit hit = march(ray, tMin, tMax, threshold, maxSteps);
    stretch = 0.0;
    return hit;
}
