// A simple scene to start from. The text is yours: change it, and the picture shows the result, or
// any errors, as soon as the text is saved or, on a page, as you type.
//
// The library is in shaders/. To use its functions, include one of its files, as below.

uniform float radius; // 1 in [0.1, 3], scene units: radius of the ball; the arrow keys change it

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox and others

// The ray of a pixel.
Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// The distance from p to the scene, a ball. Try min() with a second shape.
float sceneDistance(vec3 p)
{
    return sdSphere(p, radius);
}

// The colour that the ray finds: a sky that darkens upwards, or the ball, lit from the upper right.
vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, 40.0, 0.0005, 256);
    if (!hit.found)
        return mix(vec3(0.75, 0.85, 0.95), vec3(0.30, 0.50, 0.75), 0.5 + 0.5 * ray.direction.y);
    vec3 normal = normalAt(ray.origin + hit.t * ray.direction, 0.001);
    float light = max(dot(normal, normalize(vec3(2.0, 3.0, 2.0))), 0.0);
    return vec3(0.95, 0.60, 0.35) * (0.15 + 0.85 * light);
}
