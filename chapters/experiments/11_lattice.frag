// Experiment of chapter 11: an endlessly repeated ball, and a box. This is the scene of the
// workshop's section on repetition, with its two mistakes.
//
//   shifted=true  the workshop's repeat(), mod(x, period) - period / 2: the balls are shifted by
//                 half a period from the centre of the box, and the faces of the box cut them
//   cut=0         max(box, balls), which the workshop calls a subtraction, is the intersection
//   cut=1         max(box, -balls): the box minus the balls
#include "main.glsl"
#include "cone.glsl"
#include "normal.glsl"
#include "primitives.glsl"
#include "combine.glsl"
#include "repetition.glsl"
#include "lighting.glsl"
#include "shadow.glsl"
#include "bounds.glsl"

uniform bool  shifted; // false: use the workshop's repeat, which is off by half a period
uniform int   cut;     // 0 in [0, 1]: 0 intersection of box and balls, 1 box minus balls
uniform float radius;  // 0.42 in [0.1, 0.7] step 0.02, scene units: radius of the balls, which are 1 apart

const vec3 HALF_SIZE = vec3(2.5); // half size of the box, scene units
const vec3 REACH = vec3(2.75);    // half size of a box around everything
const vec3 TO_LIGHT = vec3(-0.48, 0.64, 0.6);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// The workshop's repeat, which is -period / 2 at 0.
float workshopRepeat(float x, float period)
{
    return mod(x, period) - 0.5 * period;
}

vec3 repeated(vec3 p)
{
    vec3 right = vec3(opRepeat(p.x, 1.0), opRepeat(p.y, 1.0), opRepeat(p.z, 1.0));
    vec3 theirs = vec3(workshopRepeat(p.x, 1.0), workshopRepeat(p.y, 1.0), workshopRepeat(p.z, 1.0));
    return shifted ? theirs : right;
}

float sceneDistance(vec3 p)
{
    float box = sdBox(p, HALF_SIZE), balls = sdSphere(repeated(p), radius);
    return cut == 0 ? opIntersection(box, balls) : opSubtraction(box, balls);
}

vec3 skyLight(vec3 direction)
{
    return mix(vec3(0.45, 0.42, 0.36), vec3(0.10, 0.16, 0.22), smoothstep(-0.4, 0.5, direction.y));
}

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, -REACH, REACH);
    Hit hit = marchCone(ray, interval.x, interval.y, 0.001, pixelSpread(), 160);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        float width = 0.001 + pixelSpread() * hit.t;
        vec3 normal = normalAt(p, width);
        Ray toLight = shadowRay(p, normal, TO_LIGHT, 4.0 * width);
        float far = shadowReach(normal, TO_LIGHT, boxInterval(toLight, -REACH, REACH).y);
        float seen = coneReaching(toLight, 0.0, far, 2.0 * width, 0.03, 96) * lambert(normal, TO_LIGHT);
        vec3 ivory = vec3(0.75, 0.63, 0.45);
        light = ivory * (seen * vec3(1.25, 1.10, 0.90) + vec3(0.10, 0.12, 0.15) * (1.0 + 0.5 * normal.y));
    }
    return encodeSRGB(light);
}
