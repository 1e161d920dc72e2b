// Solution to exercise 02.1: a third, green lamp above the left side of the stage. Its light is
// added to that of the other two lamps.
#include "main.glsl"
#define rayColour chapterRayColour
#include "02_lighting.frag"
#undef rayColour

uniform vec3 greenColour; // 0.05, 0.3, 0.1 in [0, 4], linear RGB: the light of the third lamp

const vec3 GREEN_LAMP = vec3(-1.6, 2.2, 1.4);

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, normalStep);
        vec3 third = lampLight(normal, GREEN_LAMP - p, greenColour);
        light = objectColour * (receivedLight(p, normal) + third);
    }
    return encoded ? encodeSRGB(light) : light;
}
