// 01 Normal colouring: the direction in which each surface faces, shown as a colour.
//
// The scene is a frame, a ball in it and an orbit of smaller balls, in front of a sky of one
// colour. There is no light yet: x of the normal is shown as red, y as green and z as blue.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBoxFrame

uniform float normalStep;   // 0.001 in [0.0000001, 0.5] step *2, scene units: step of the differences that give the normal
uniform int   maxSteps;     // 256 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.2] step *2, scene units: a distance below this counts as a hit
uniform bool  biased;       // false: show 0.5 N + 0.5 instead of N, whose negative half is black

const float FAR = 40.0; // a ray that has travelled this far meets the sky

const vec3 SKY = vec3(0.5, 0.7, 1.0);

// Centres (xyz) and radii (w) of the balls around the frame, on a tilted orbit.
const vec4 ORBIT[8] = vec4[8](
    vec4( 1.64, -0.15, -0.23, 0.16), vec4( 1.33, -0.38,  1.00, 0.20),
    vec4( 0.23, -0.38,  1.64, 0.23), vec4(-1.00, -0.17,  1.33, 0.27),
    vec4(-1.64,  0.15,  0.23, 0.30), vec4(-1.33,  0.38, -1.00, 0.34),
    vec4(-0.23,  0.38, -1.64, 0.37), vec4( 1.00,  0.17, -1.33, 0.41));

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    float scene = sdBoxFrame(p, vec3(0.8), 0.08);
    scene = min(scene, sdSphere(p, 0.52));
    for (int i = 0; i < 8; i++)
        scene = min(scene, sdSphere(p - ORBIT[i].xyz, ORBIT[i].w));
    return scene;
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    if (!hit.found)
        return SKY;
    vec3 normal = normalAt(ray.origin + hit.t * ray.direction, normalStep);
    return biased ? 0.5 * normal + 0.5 : normal;
}
