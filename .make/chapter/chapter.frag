// @number@ @title@: one sentence on what it shows.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox
#include "lighting.glsl"   // lambert, encodeSRGB

uniform float ballRadius;   // 0.8 in [0.1, 2] step 0.05, scene units: radius of the ball
uniform int   maxSteps;     // 256 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

const float FAR = 40.0; // a ray that has travelled this far shows the sky

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    float ball = sdSphere(p - vec3(0.0, ballRadius, 0.0), ballRadius);
    float ground = sdBox(p - vec3(0.0, -0.1, 0.0), vec3(2.4, 0.1, 2.4));
    return min(ball, ground);
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    vec3 light = mix(vec3(0.10, 0.16, 0.20), vec3(0.03, 0.05, 0.09), smoothstep(-0.4, 0.4, ray.direction.y));
    if (hit.found) {
        vec3 normal = normalAt(ray.origin + hit.t * ray.direction, 0.001);
        light = vec3(0.04, 0.06, 0.09) + vec3(0.9, 0.7, 0.5) * lambert(normal, normalize(vec3(2.0, 3.0, 2.0)));
    }
    return encodeSRGB(light);
}
