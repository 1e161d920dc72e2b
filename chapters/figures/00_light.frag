// A ball in the light of a lamp: drag the lamp around the ball and behind it. A surface that faces the lamp is bright;
// a surface that faces away has only a tenth of that brightness. In a page, drag the picture to walk around the ball.
#include "main.glsl"
#include "lighting.glsl"
#include "march.glsl"
#include "normal.glsl"
#include "primitives.glsl"

uniform vec3 lamp; // -1.15, 0.75, -1.9 in [-6, 6] step 0.1, handle scene units: the lamp

Ray pixelRay(vec2 screen)
{
    return Ray(iCameraPosition, normalize(screen.x * iCameraRight + screen.y * iCameraUp + 1.5 * iCameraForward));
}

float sceneDistance(vec3 p)
{
    return min(sdSphere(p - vec3(0.0, 0.0, -3.0), 1.0), p.y + 1.0);
}

// The parts of a vector to the right, upwards and forward.
vec3 inCamera(vec3 v)
{
    return vec3(dot(v, iCameraRight), dot(v, iCameraUp), dot(v, iCameraForward));
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, 40.0, 0.001, 200);
    vec3 p = ray.origin + hit.t * ray.direction, normal = normalAt(p, 0.001);
    vec3 colour = vec3(0.5, 0.7, 1.0);
    if (hit.found)
        colour = vec3(1.0, 0.9, 0.7) * (0.1 + 0.9 * lambert(normal, normalize(lamp - p)));
    // The distance on the screen between this pixel and the lamp.
    vec3 toLamp = lamp - iCameraPosition, here = inCamera(ray.direction), there = inCamera(toLamp);
    float beside = 1.5 * length(here.xy / here.z - there.xy / there.z);
    bool visible = there.z > 0.0 && (!hit.found || length(toLamp) < hit.t);
    return visible ? mix(colour, vec3(1.0, 0.97, 0.85), (1.0 - smoothstep(0.031, 0.037, beside))) : colour;
}
