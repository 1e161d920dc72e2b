// Experiment of chapter 00: the chapter's eye, scene and march in the form that chapter 01
// introduces, so that the views can show the rays. The picture is the same as the chapter's.
#include "main.glsl"
#include "march.glsl"
#include "normal.glsl"
#include "primitives.glsl"

Ray pixelRay(vec2 screen)
{
    vec3 eye = vec3(1.8 * sin(0.5 * iTime), 1.0, 1.8 * cos(0.5 * iTime));
    vec3 forward = normalize(-eye);
    vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
    vec3 up = cross(right, forward);
    return Ray(eye, normalize(screen.x * right + screen.y * up + 1.8 * forward));
}

float sceneDistance(vec3 p)
{
    return min(sdBoxFrame(p, vec3(0.5), 0.05), sdSphere(p, 0.3));
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, 20.0, 0.0005, 128);
    if (!hit.found)
        return mix(vec3(0.03, 0.05, 0.12), vec3(0.26, 0.32, 0.52), 1.0 + ray.direction.y); // the dusk
    vec3 p = ray.origin + hit.t * ray.direction;
    vec3 normal = normalAt(p, 0.001);
    if (sdSphere(p, 0.3) < 0.001)
        return mix(vec3(1.0, 0.6, 0.2), vec3(1.0, 0.95, 0.8), -dot(normal, ray.direction)); // the lamp
    vec3 toLamp = -p;
    float lamp = max(dot(normal, normalize(toLamp)), 0.0) / dot(toLamp, toLamp);
    float moon = max(dot(normal, normalize(vec3(1.0, 2.0, 3.0))), 0.0);
    return lamp * vec3(0.40, 0.27, 0.15) + (0.3 + moon) * vec3(0.22, 0.28, 0.40);
}
