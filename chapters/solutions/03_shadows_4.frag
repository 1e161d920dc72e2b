// Solution to exercise 03.4: a lamp that consists of nine points. Each point emits a ninth of the
// light and casts a separate shadow, so the edge of a shadow becomes a series of steps.
#include "main.glsl"
#define rayColour chapterRayColour
#include "03_shadows.frag"
#undef rayColour

uniform float lampSide; // 0.6 in [0, 2] step 0.1, scene units: side of the square that contains the points

vec3 nineLamps(vec3 p, vec3 normal)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 9; i++) {
        vec3 offset = 0.5 * lampSide * vec3(float(i % 3 - 1), 0.0, float(i / 3 - 1));
        vec3 toLamp = lampPosition() + offset - p;
        float seen = visibility(p, normal, normalize(toLamp), length(toLamp));
        sum += seen * lampLight(normal, toLamp, LAMP_COLOUR / 9.0);
    }
    return sum;
}

vec3 rayColour(Ray ray)
{
    vec2 interval = sceneInterval(ray);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, normalStep);
        vec3 coldLight = lampLight(normal, COLD_LAMP - p, COLD_COLOUR);
        light = OBJECT_COLOUR * (AMBIENT + nineLamps(p, normal) + coldLight);
    }
    return encodeSRGB(light);
}
