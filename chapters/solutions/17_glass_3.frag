// Solution to exercise 17.3: red where no light gets out at the second surface.
#include "main.glsl"
#define rayColour chapterRayColour
#include "17_glass.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit first = marchSide(ray, 1.0, interval.x, interval.y, hitThreshold, maxSteps);
    bool total = false;
    if (first.found) {
        vec3 p = ray.origin + first.t * ray.direction, normal = normalAt(p, hitThreshold);
        float index = cauchyIndex(glassAt(p).cauchy, 0.55);
        vec3 bent = refract(ray.direction, normal, 1.0 / index);
        Ray inside = leavingRay(p, normal, bent, startOffset * hitThreshold);
        Hit second = marchSide(inside, -1.0, 0.0, 9.0, hitThreshold, maxSteps);
        normal = normalAt(inside.origin + second.t * bent, hitThreshold);
        total = second.found && refract(bent, -normal, index) == vec3(0.0);
    }
    float grey = first.found ? 0.7 : 0.9;
    return total ? vec3(0.8, 0.1, 0.1) : vec3(grey);
}
