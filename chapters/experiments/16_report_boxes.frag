// The report's figure 9, redrawn: the frame of a box and a column of balls, their shadow on a slab,
// and their reflection in the polished slab.
//
// The two rays of a pixel, the ray from the eye and the reflected ray, share one loop: on a machine
// whose pixels run in lockstep, a block of pixels can leave a loop early, but it has to run the
// body of every if.
#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdBoxFrame, sdSphere
#include "repetition.glsl" // opRepeatLimited
#include "bounds.glsl"     // boxInterval, intervalUnion
#include "shadow.glsl"     // shadowRay, shadowReach
#include "lighting.glsl"   // lambert, encodeSRGB
#include "fresnel.glsl"    // schlickShare

uniform bool  clipped;      // true: march only inside the boxes around the frame and the balls
uniform int   rays;         // 2 in [1, 2]: only the ray from the eye, or also the reflected ray
uniform int   maxSteps;     // 128 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0003 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

// Lengths as measured in the figure; the unit is the side of the frame.
const float FAR = 20.0;                            // a ray that has travelled this far meets the sky
const float FRAME = 0.5, BEAM = 0.05;              // half the frame's side, half a beam's thickness
const float BALL = 0.15;                           // radius of a ball
const float LAST = 3.0;                            // there is a ball at each integer height from 0 to LAST
const vec3  SLAB = vec3(0.0, -0.96, 0.0);          // centre and half size of the slab
const vec3  SLAB_HALF = vec3(1.5, 0.1, 1.5);
const float MARGIN = 0.01;                         // how much larger the bounds are than their contents

const vec3  TO_SUN = vec3(0.28606, 0.90525, -0.31503); // length 1 to three digits
const vec3  SUN_COLOUR = vec3(1.12, 0.96, 0.76);   // light of the sun on a surface that faces it, linear RGB
const vec3  SKY_LIGHT = vec3(0.07, 0.14, 0.17);    // ambient light on a surface that faces the sun
const vec3  SLAB_LIGHT = vec3(0.015, 0.022, 0.03); // ambient light on a surface that faces away from the sun
const vec3  OBJECT_COLOUR = vec3(0.86, 0.83, 0.78);
const vec3  SLAB_COLOUR = vec3(0.26, 0.27, 0.28);
const float STRAIGHT = 0.14;                       // share of the light that the slab reflects at normal incidence

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// The distance to the frame and the balls, without the slab.
float sceneDistance(vec3 p)
{
    float column = sdSphere(vec3(p.x, opRepeatLimited(p.y, 1.0, 0.0, LAST), p.z), BALL);
    return min(sdBoxFrame(p, vec3(FRAME), BEAM), column);
}

// Where a march has to search: in the boxes around the frame and the balls.
vec2 sceneInterval(Ray ray)
{
    vec2 frame = boxInterval(ray, vec3(-FRAME - MARGIN), vec3(FRAME + MARGIN));
    vec2 column = boxInterval(ray, vec3(-BALL - MARGIN), vec3(0.0, LAST, 0.0) + BALL + MARGIN);
    return clipped ? intervalUnion(frame, column) : vec2(0.0, FAR);
}

// The sky of the figure: teal above, night below.
vec3 skyLight(vec3 direction)
{
    vec3 high = mix(vec3(0.0, 0.075, 0.13), vec3(0.16, 0.46, 0.58), smoothstep(0.0, 0.5, direction.y));
    return mix(vec3(0.0, 0.001, 0.008), high, smoothstep(-0.55, 0.05, direction.y));
}

// The light that a matt surface receives from the sky, the slab and, where it is visible, the sun.
vec3 receivedLight(vec3 p, vec3 normal)
{
    Ray ray = shadowRay(p, normal, TO_SUN, 4.0 * hitThreshold);
    vec2 interval = sceneInterval(ray);
    float far = shadowReach(normal, TO_SUN, interval.y);
    float seen = march(ray, interval.x, far, hitThreshold, maxSteps).found ? 0.0 : 1.0;
    vec3 around = mix(SLAB_LIGHT, SKY_LIGHT, 0.5 + 0.5 * dot(normal, TO_SUN));
    return around + seen * lambert(normal, TO_SUN) * SUN_COLOUR;
}

// Where a ray ends: at the frame, the balls or the slab, or in the sky.
struct Spot {
    vec3 p, normal;
    bool met, onSlab;
};

Spot spotAlong(Ray ray)
{
    vec2 slab = boxInterval(ray, SLAB - SLAB_HALF, SLAB + SLAB_HALF), interval = sceneInterval(ray);
    float end = slab.x < slab.y ? slab.x : FAR;
    Hit hit = march(ray, interval.x, min(interval.y, end), hitThreshold, maxSteps);
    float t = hit.found ? hit.t : end;
    vec3 p = ray.origin + t * ray.direction, aside = abs(p - SLAB) - SLAB_HALF;
    float outside = max(aside.x, max(aside.y, aside.z)); // distance to the slab's surface, negative inside
    bool met = hit.found || end < FAR, onSlab = met && outside < 2.0 * hitThreshold;
    vec3 normal = onSlab ? step(outside, aside) * sign(p - SLAB) : normalAt(p, hitThreshold);
    if (met) { // report the slab to the views and the probe too
        traceNormal(normal);
        traceMarch(trace.steps, t, END_HIT);
    }
    return Spot(p, normal, met, onSlab);
}

vec3 rayColour(Ray ray)
{
    vec3 light = vec3(0.0);
    float share = 1.0; // weight of the ray's light in the pixel
    for (int turn = 0; turn < rays && share > 0.0; turn++) {
        Spot spot = spotAlong(ray);
        vec3 seen = (spot.onSlab ? SLAB_COLOUR : OBJECT_COLOUR) * receivedLight(spot.p, spot.normal);
        light += share * (spot.met ? seen : skyLight(ray.direction));

        // Continue with the reflected ray if it can hit something. Otherwise it meets the sky,
        // which needs no further iteration.
        share *= spot.onSlab ? schlickShare(max(-dot(ray.direction, spot.normal), 0.0), STRAIGHT) : 0.0;
        ray = Ray(spot.p + 4.0 * hitThreshold * spot.normal, reflect(ray.direction, spot.normal));
        vec2 interval = sceneInterval(ray);
        bool sky = interval.x >= interval.y || turn + 1 == rays;
        light += sky ? share * skyLight(ray.direction) : vec3(0.0);
        share = sky ? 0.0 : share;
    }
    return encodeSRGB(light);
}
