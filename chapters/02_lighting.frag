// 02 Lighting: a lamp, a matt surface, and the light that the surface sends to the eye.
//
// The scene is a stage with a frame, balls and a block, under a warm, circling lamp and a cold,
// fixed one. There are no shadows yet: the lamps shine through everything.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox, sdBoxFrame
#include "lighting.glsl"   // lambert, fallOff, encodeSRGB

uniform vec3  lampColour;   // 1.0, 0.72, 0.45 in [0, 4], linear RGB: the lamp's light at the reference distance
uniform float lampHeight;   // 4.6 in [0.5, 8] step 0.1, scene units: height of the lamp above the stage
uniform float lampSpeed;    // 20 in [0, 180] step 5, degrees per second: how fast the lamp circles
uniform vec3  coldColour;   // 0.06, 0.14, 0.3 in [0, 4], linear RGB: the light of the second lamp
uniform vec3  ambient;      // 0.012, 0.02, 0.035 in [0, 1], linear RGB: light that comes from all directions
uniform bool  falloff;      // true: a lamp weakens with the square of the distance; the report omits this
uniform vec3  objectColour; // 0.95, 0.9, 0.85 in [0, 1], linear RGB: the share of each colour that the surface reflects
uniform bool  encoded;      // true: encode linear light as a screen expects it
uniform int   maxSteps;     // 256 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.2] step *2, scene units: a distance below this counts as a hit
uniform float normalStep;   // 0.001 in [0.0000001, 0.5] step *2, scene units: step of the differences that give the normal

const float FAR = 40.0;                       // a ray that has travelled this far meets the sky
const float REFERENCE = 6.0;                  // distance at which a lamp's light equals its colour, scene units
const vec3  COLD_LAMP = vec3(-5.0, 3.0, 4.0); // position of the second lamp

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

vec3 lampPosition()
{
    float angle = radians(35.0 + lampSpeed * iTime);
    return vec3(4.2 * cos(angle), lampHeight, -4.2 * sin(angle));
}

// The light that one lamp adds: Lambert's law times the lamp's colour. If falloff is set, the light
// also weakens with distance.
//   toLamp  vector from the surface to the lamp, scene units
vec3 lampLight(vec3 normal, vec3 toLamp, vec3 colour)
{
    float distance = length(toLamp);
    float weakened = falloff ? fallOff(distance, REFERENCE) : 1.0;
    return colour * weakened * lambert(normal, toLamp / distance);
}

// All the light that arrives at a point: the light of both lamps plus the ambient light.
vec3 receivedLight(vec3 p, vec3 normal)
{
    return ambient + lampLight(normal, lampPosition() - p, lampColour) +
           lampLight(normal, COLD_LAMP - p, coldColour);
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
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        light = objectColour * receivedLight(p, normalAt(p, normalStep));
    }
    return encoded ? encodeSRGB(light) : light;
}
