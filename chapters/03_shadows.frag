// 03 Shadows: the stage of chapter 02, and a second march that checks whether the lamp is visible.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox, sdBoxFrame
#include "lighting.glsl"   // lambert, fallOff, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach, lightReaching
#include "bounds.glsl"     // boxInterval

uniform bool  sun;          // false: treat the lamp as a sun, with a direction instead of a position
uniform bool  shadows;      // true: check whether the light is visible from the surface
uniform float shadowOffset; // 4 in [0, 40] step 0.25, times the threshold: height above the surface where a shadow ray starts
uniform bool  clipped;      // true: march only inside the box that contains the scene
uniform float lampHeight;   // 4.6 in [0.5, 8] step 0.1, scene units: height of the lamp above the stage
uniform float lampSpeed;    // 20 in [0, 180] step 5, degrees per second: how fast the lamp circles
uniform int   maxSteps;     // 256 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.2] step *2, scene units: a distance below this counts as a hit
uniform float normalStep;   // 0.001 in [0.0000001, 0.5] step *2, scene units: step of the differences that give the normal

const float FAR = 40.0;                           // a ray that has travelled this far meets the sky
const vec3  LOW = vec3(-2.65, -0.25, -2.25);      // opposite corners of a box that contains the scene
const vec3  HIGH = vec3(2.65, 2.45, 2.25);

// The light of chapter 02, in linear RGB. Its parameters in that chapter are constants here.
const vec3  LAMP_COLOUR = vec3(1.0, 0.72, 0.45);  // light of the circling lamp at the reference distance
const vec3  COLD_COLOUR = vec3(0.06, 0.14, 0.3);  // light of the second lamp, which casts no shadow
const vec3  COLD_LAMP = vec3(-5.0, 3.0, 4.0);     // position of the second lamp
const float REFERENCE = 6.0;                      // distance at which a lamp's light equals its colour, scene units
const vec3  AMBIENT = vec3(0.012, 0.02, 0.035);   // light that comes from all directions
const vec3  OBJECT_COLOUR = vec3(0.95, 0.9, 0.85);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    float stage = sdBox(p - vec3(0.0, -0.1, 0.0), vec3(2.6, 0.1, 2.2));
    float frame = sdBoxFrame(p - vec3(0.4, 0.8, -0.5), vec3(0.8), 0.07);
    float inside = sdSphere(p - vec3(0.4, 0.8, -0.5), 0.36);
    float above = sdSphere(p - vec3(0.4, 2.05, -0.5), 0.28);
    float resting = sdSphere(p - vec3(1.75, 0.4, 1.2), 0.4);
    float block = sdBox(p - vec3(-1.6, 0.3, 0.1), vec3(0.35, 0.3, 0.55));
    return min(min(min(stage, frame), min(inside, above)), min(resting, block));
}

// The room around a camera at p, which must stay at least 0.15 scene units away from the scene.
float cameraRoom(vec3 p)
{
    return sceneDistance(p) - 0.15;
}

vec3 lampPosition()
{
    float angle = radians(35.0 + lampSpeed * iTime);
    return vec3(4.2 * cos(angle), lampHeight, -4.2 * sin(angle));
}

// The light that one lamp adds: Lambert's law times the lamp's colour, weakened with distance.
//   toLamp  vector from the surface to the lamp, scene units
vec3 lampLight(vec3 normal, vec3 toLamp, vec3 colour)
{
    float distance = length(toLamp);
    return colour * fallOff(distance, REFERENCE) * lambert(normal, toLamp / distance);
}

// The interval in which a ray can hit the scene.
vec2 sceneInterval(Ray ray)
{
    return clipped ? boxInterval(ray, LOW, HIGH) : vec2(0.0, FAR);
}

// 0 if the scene blocks the light, otherwise 1. The shadow ray is marched only if the surface faces
// the light, and no farther than the lamp.
float visibility(vec3 p, vec3 normal, vec3 toLight, float distance)
{
    Ray ray = shadowRay(p, normal, toLight, shadowOffset * hitThreshold);
    float far = shadowReach(normal, toLight, min(distance, sceneInterval(ray).y));
    return lightReaching(ray, shadows ? far : 0.0, hitThreshold, maxSteps);
}

// The light of the circling lamp. If sun is set, the light comes from the same direction at every
// point.
vec3 warmLight(vec3 p, vec3 normal)
{
    vec3 toLamp = sun ? lampPosition() : lampPosition() - p;
    float distance = length(toLamp);
    float seen = visibility(p, normal, toLamp / distance, sun ? FAR : distance);
    return seen * lampLight(normal, toLamp, LAMP_COLOUR);
}

// A dark hall: far below the stage, a pool of cold light on the floor, which fades towards the horizon.
vec3 skyLight(vec3 direction)
{
    float down = max(-direction.y, 0.0);
    vec2 aside = direction.xz - down * vec2(-0.9, -2.2);
    float pool = down * down / (down * down + 0.4 * dot(aside, aside) + 0.001);
    return mix(vec3(0.003, 0.006, 0.016), vec3(0.06, 0.14, 0.18), pool);
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
        light = OBJECT_COLOUR * (AMBIENT + warmLight(p, normal) + coldLight);
    }
    return encodeSRGB(light);
}
