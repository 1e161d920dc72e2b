// Experiment of chapter 16: four scenes that are hard for a march, and one march of 16_marches.glsl. The colour of a
// pixel shows the number of evaluations.
#ifndef MARCH
#define MARCH PLAIN // or RELAXED, ENHANCED, SEGMENT, OVERSTEP, CONE, COARSE, TIGHT
#endif
#define FALL_KNOWN

#include "main.glsl"
#include "camera.glsl"
#include "primitives.glsl" // sdBox, sdBoxFrame
#include "16_marches.glsl"

#ifndef STRESS
uniform int stress; // 3 in [0, 3]: a thin torus, a plane at a grazing angle, a hollow cube, a stack of thin plates
#define STRESS stress
#endif
uniform float hitThreshold; // 0.0005 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit

const float FAR = 40.0;
const vec2  TORUS = vec2(1.3, 0.01);   // radius of the circle and of the tube, scene units
const float GROUND = 0.9;              // height of the plane
const vec3  CUBE = vec3(0.8);          // half the size of the cube
const float BEAM = 0.02;               // half the thickness of the cube's beams
const vec3  PLATE = vec3(1.0, 0.002, 1.0); // half the size of a plate
const int   PLATES = 9;
const float APART = 0.2;

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

vec3 cubePoint(vec3 p)
{
    return vec3(0.8 * p.x + 0.6 * p.z, p.y, 0.8 * p.z - 0.6 * p.x);
}

float sceneDistance(vec3 p)
{
    if (STRESS == 0)
        return length(vec2(length(p.xz) - TORUS.x, p.y)) - TORUS.y;
    if (STRESS == 1)
        return p.y - GROUND;
    if (STRESS == 2)
        return sdBoxFrame(cubePoint(p), CUBE, BEAM);
    float nearest = 1e9;
    for (int i = 0; i < PLATES; i++)
        nearest = min(nearest, sdBox(p - vec3(0.0, APART * float(i - PLATES / 2), 0.0), PLATE));
    return nearest;
}

// How fast the distance to a box falls at p in the direction v. The box is convex, so the distance never falls faster
// later on the ray.
float boxFall(vec3 p, vec3 v, vec3 halfSize)
{
    vec3 beyond = abs(p) - halfSize, out3 = max(beyond, 0.0);
    float largest = max(beyond.x, max(beyond.y, beyond.z));
    vec3 face = step(vec3(largest), beyond);
    vec3 normal = largest > 0.0 ? out3 / length(out3) : face / length(face);
    return -dot(sign(p) * normal, v);
}

// The torus is not convex. With R the radius of its circle, q the distance to its axis and D the distance to its
// circle, the second derivative of the distance along a ray is at least -(R - q) / (q D) where q < R, and at least 0
// elsewhere.
float torusFall(vec3 p, vec3 v, float reach)
{
    float q = length(p.xz), D = length(vec2(q - TORUS.x, p.y));
    vec3 normal = vec3(p.x * (q - TORUS.x) / max(q, 1e-6), p.y, p.z * (q - TORUS.x) / max(q, 1e-6)) / max(D, 1e-6);
    float least = max(q - reach * length(v.xz), 1e-6), near = max(D - reach, TORUS.y);
    return -dot(normal, v) + reach * max(TORUS.x - least, 0.0) / (least * near);
}

float fallAlong(vec3 p, vec3 v, float reach)
{
    if (STRESS == 0)
        return torusFall(p, v, reach);
    if (STRESS == 1)
        return -v.y;
    float fall = -1.0;
    if (STRESS == 2) {
        vec3 q = cubePoint(p), u = cubePoint(v);
        for (int i = 0; i < 12; i++) {
            vec3 side = vec3(i % 2, i / 2 % 2, 0.0) * 2.0 - vec3(1.0, 1.0, 0.0), size = vec3(BEAM, BEAM, CUBE.z);
            side *= CUBE.x - BEAM;
            side = i < 4 ? side : (i < 8 ? side.zxy : side.yzx);
            size = i < 4 ? size : (i < 8 ? size.zxy : size.yzx);
            fall = max(fall, boxFall(q - side, u, size));
        }
        return fall;
    }
    for (int i = 0; i < PLATES; i++)
        fall = max(fall, boxFall(p - vec3(0.0, APART * float(i - PLATES / 2), 0.0), v, PLATE));
    return fall;
}

float coarseMargin(float t)
{
    return hitThreshold;
}

vec3 rayColour(Ray ray)
{
    march(ray, 0.0, FAR, hitThreshold, 0);
    return marchColour();
}
