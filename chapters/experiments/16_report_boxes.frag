// The report's figure 9 drawn again: the frame of a box and a column of balls, their shadow on a slab, and
// what the polished slab mirrors of them.
//
// The rays of a pixel, the eye's and the mirrored one, take turns in one loop: on a machine that runs in
// lockstep a loop is what a block of pixels can leave early, an if is not.
#include "main.glsl"       // main(): asks for pixelRay, then for rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdBoxFrame, sdSphere
#include "repetition.glsl" // opRepeatLimited
#include "bounds.glsl"     // boxInterval, intervalUnion
#include "shadow.glsl"     // shadowRay, shadowReach
#include "lighting.glsl"   // lambert, encodeSRGB
#include "fresnel.glsl"    // schlickShare

uniform bool  clipped;      // true: march only inside the boxes that hold frame and balls
uniform int   rays;         // 2 in [1, 2]: the eye's alone, or the mirrored one too
uniform int   maxSteps;     // 128 in [1, 1024]: steps before a ray is given up
uniform float hitThreshold; // 0.0003 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

// Lengths as measured in the figure, in sides of the frame.
const float FAR = 20.0;                            // a ray that has travelled so far sees the sky
const float FRAME = 0.5, BEAM = 0.05;              // half the frame's side, half a beam's thickness
const float BALL = 0.15;                           // radius of a ball
const float LAST = 3.0;                            // balls stand at the whole heights from 0 to LAST
const vec3  SLAB = vec3(0.0, -0.96, 0.0);          // centre and half size of the slab
const vec3  SLAB_HALF = vec3(1.5, 0.1, 1.5);
const float MARGIN = 0.01;                         // by which the bounds are larger than what they hold

const vec3  TO_SUN = vec3(0.28606, 0.90525, -0.31503); // length 1
const vec3  SUN_COLOUR = vec3(1.12, 0.96, 0.76);   // its light on a surface that faces it, linear RGB
const vec3  SKY_LIGHT = vec3(0.07, 0.14, 0.17);    // of the side of the sky where the sun is, and of the other
const vec3  SLAB_LIGHT = vec3(0.015, 0.022, 0.03);
const vec3  OBJECT_COLOUR = vec3(0.86, 0.83, 0.78);
const vec3  SLAB_COLOUR = vec3(0.26, 0.27, 0.28);
const float STRAIGHT = 0.14;                       // the share that the slab mirrors of a ray that falls straight

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// Frame and balls: the slab is no part of the distance.
float sceneDistance(vec3 p)
{
    float column = sdSphere(vec3(p.x, opRepeatLimited(p.y, 1.0, 0.0, LAST), p.z), BALL);
    return min(sdBoxFrame(p, vec3(FRAME), BEAM), column);
}

// Where a march has to look: in the boxes that hold frame and balls.
vec2 sceneInterval(Ray ray)
{
    vec2 frame = boxInterval(ray, vec3(-FRAME - MARGIN), vec3(FRAME + MARGIN));
    vec2 column = boxInterval(ray, vec3(-BALL - MARGIN), vec3(0.0, LAST, 0.0) + BALL + MARGIN);
    return clipped ? intervalUnion(frame, column) : vec2(0.0, FAR);
}

// The sky of the figure: teal above, the night below.
vec3 skyLight(vec3 direction)
{
    vec3 high = mix(vec3(0.0, 0.075, 0.13), vec3(0.16, 0.46, 0.58), smoothstep(0.0, 0.5, direction.y));
    return mix(vec3(0.0, 0.001, 0.008), high, smoothstep(-0.55, 0.05, direction.y));
}

// Light of the sky and the slab on a matt surface, and of the sun where it is in sight.
vec3 receivedLight(vec3 p, vec3 normal)
{
    Ray ray = shadowRay(p, normal, TO_SUN, 4.0 * hitThreshold);
    vec2 interval = sceneInterval(ray);
    float far = shadowReach(normal, TO_SUN, interval.y);
    float seen = march(ray, interval.x, far, hitThreshold, maxSteps).found ? 0.0 : 1.0;
    vec3 around = mix(SLAB_LIGHT, SKY_LIGHT, 0.5 + 0.5 * dot(normal, TO_SUN));
    return around + seen * lambert(normal, TO_SUN) * SUN_COLOUR;
}

// Where a ray ends: at frame, balls or slab, or in the sky.
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
    float outside = max(aside.x, max(aside.y, aside.z)); // of the slab
    bool met = hit.found || end < FAR, onSlab = met && outside < 2.0 * hitThreshold;
    vec3 normal = onSlab ? step(outside, aside) * sign(p - SLAB) : normalAt(p, hitThreshold);
    if (met) { // for the views and the probe, the slab too
        traceNormal(normal);
        traceMarch(trace.steps, t, END_HIT);
    }
    return Spot(p, normal, met, onSlab);
}

vec3 rayColour(Ray ray)
{
    vec3 light = vec3(0.0);
    float share = 1.0; // of what the ray sees in what the eye sees
    for (int turn = 0; turn < rays && share > 0.0; turn++) {
        Spot spot = spotAlong(ray);
        vec3 seen = (spot.onSlab ? SLAB_COLOUR : OBJECT_COLOUR) * receivedLight(spot.p, spot.normal);
        light += share * (spot.met ? seen : skyLight(ray.direction));

        // The mirrored ray, if it may meet something. Else it sees the sky, which takes no turn.
        share *= spot.onSlab ? schlickShare(max(-dot(ray.direction, spot.normal), 0.0), STRAIGHT) : 0.0;
        ray = Ray(spot.p + 4.0 * hitThreshold * spot.normal, reflect(ray.direction, spot.normal));
        vec2 interval = sceneInterval(ray);
        bool sky = interval.x >= interval.y || turn + 1 == rays;
        light += sky ? share * skyLight(ray.direction) : vec3(0.0);
        share = sky ? 0.0 : share;
    }
    return encodeSRGB(light);
}
