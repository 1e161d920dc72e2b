// Solution to exercise 03.1: the cold lamp casts a shadow too.
#include "main.glsl"
#define rayColour chapterRayColour
#include "03_shadows.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec2 interval = sceneInterval(ray);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, normalStep);
        vec3 toCold = COLD_LAMP - p;
        float seen = visibility(p, normal, normalize(toCold), length(toCold));
        vec3 coldLight = seen * lampLight(normal, toCold, COLD_COLOUR);
        light = OBJECT_COLOUR * (AMBIENT + warmLight(p, normal) + coldLight);
    }
    return encodeSRGB(light);
}
