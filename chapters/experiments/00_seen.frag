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
        return vec3(0.5, 0.7, 1.0); // the sky
    vec3 normal = normalAt(ray.origin + hit.t * ray.direction, 0.001);
    vec3 toSun = normalize(vec3(1.0, 2.0, 3.0));
    return vec3(1.0, 0.9, 0.5) * (0.15 + 0.85 * max(dot(normal, toSun), 0.0));
}
