// 04 Hue and combination: colours come from hues, and solids are built from other solids.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach, lightReaching
#include "bounds.glsl"     // boxInterval
#include "hue.glsl"        // hsvToRGB
#include "combine.glsl"    // opUnion, opIntersection, opSubtraction, opSmoothUnion, smoothUnionShare

uniform float hueShift;     // 0 in [0, 360] step 5, degrees: turns the hues around the wheel
uniform float saturation;   // 0.97 in [0, 1] step 0.05: 0 grey, 1 the pure hue
uniform float value;        // 0.8 in [0, 1] step 0.05: the largest channel of a colour
uniform int   operation;    // 3 in [0, 3]: block and ball: 0 union, 1 intersection, 2 block minus ball, 3 smooth union
uniform float blend;        // 0.6 in [0.01, 1.5] step 0.05, scene units: width of the smooth union's blend
uniform int   maxSteps;     // 128 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.002 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit
uniform float normalStep;   // 0.001 in [0.0000001, 0.5] step *2, scene units: step of the differences that give the normal

const vec3  LOW = vec3(-3.25, -0.27, -3.25);       // opposite corners of a box around the scene
const vec3  HIGH = vec3(3.25, 1.6, 3.25);

// The wheel: x points right, z towards the viewer, and angles are measured from x towards z. A
// mirror's normal points to the side that its fold leaves unchanged.
const float RING = 2.5;                            // radius of the wheel, scene units
const vec2  MIRROR_60 = vec2(0.8660254, -0.5);     // normal of the mirror at 60 degrees
const vec2  MIRROR_30 = vec2(0.5, -0.8660254);     // normal of the mirror at 30 degrees
const vec2  ALONG_30 = vec2(0.8660254, 0.5);       // direction of the die at 30 degrees

const vec3  SUN = vec3(-0.72, 0.6, 0.3487);        // direction of the sun, length 1
const vec3  SUN_LIGHT = vec3(1.25, 1.05, 0.82);    // light of the sun, linear RGB
const vec3  SKY_LIGHT = vec3(0.28, 0.335, 0.41);   // light from the sky on an upward face
const vec3  GLOW = vec3(-0.5196, 0.1, -0.8485);    // direction in which the backdrop is brightest, length 1
const vec3  STAGE_COLOUR = vec3(0.28, 0.27, 0.265);
const float BLOCK_HUE = 255.0;                     // hues of the solids in the middle, degrees
const float BALL_HUE = 12.0;

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// Fold the plane along a mirror through the origin: replace a point behind the mirror with its
// mirror image, and leave a point in front of the mirror, where dot(q, normal) is positive,
// unchanged.
vec2 folded(vec2 q, vec2 normal)
{
    return q - 2.0 * min(dot(q, normal), 0.0) * normal;
}

// A cube with its corners and edges cut off by a ball. q is the point relative to the die's centre.
float dieDistance(vec3 q)
{
    vec3 faces = abs(q) - 0.33;
    float cube = opIntersection(faces.x, opIntersection(faces.y, faces.z));
    return opIntersection(cube, sdSphere(q, 0.45));
}

// Six balls alternate with six dice. Mirrors every 30 degrees fold every point into one wedge, with
// a ball on one of its two mirrors and a die on the other. fromBall and fromDie are the point
// relative to the ball and to the die: x points away from the axis of the wheel, y up, z sideways.
float wheelDistance(vec3 p)
{
    vec2 q = folded(folded(abs(p.xz), MIRROR_60), MIRROR_30);
    vec3 fromBall = vec3(q.x - RING, p.y - 0.3, q.y);
    vec3 fromDie = vec3(dot(q, ALONG_30) - RING, p.y - 0.28, dot(q, MIRROR_30));
    return opUnion(sdSphere(fromBall, 0.4), dieDistance(fromDie));
}

// A round stage with a groove: the intersection of a cylinder and a slab, minus a torus.
float stageDistance(vec3 p)
{
    vec2 q = vec2(length(p.xz), p.y);
    float disc = opIntersection(q.x - 3.2, abs(q.y + 0.12) - 0.12);
    return opSubtraction(disc, length(q - vec2(RING, 0.5)) - 0.6);
}

// The solids in the middle: a block, and a ball that rises and sinks once every ten seconds.
float blockDistance(vec3 p)
{
    return sdBox(p - vec3(0.0, 0.24, 0.0), vec3(0.9, 0.28, 0.9));
}

float ballDistance(vec3 p)
{
    float swing = abs(2.0 * fract(0.1 * iTime) - 1.0);
    float height = 0.2 + 0.7 * swing * swing * (3.0 - 2.0 * swing);
    return sdSphere(p - vec3(0.0, height, 0.0), 0.6);
}

float middleDistance(vec3 p)
{
    float a = blockDistance(p), b = ballDistance(p);
    if (operation == 0)
        return opUnion(a, b);
    if (operation == 1)
        return opIntersection(a, b);
    return operation == 2 ? opSubtraction(a, b) : opSmoothUnion(a, b, blend);
}

float sceneDistance(vec3 p)
{
    return opUnion(opUnion(stageDistance(p), wheelDistance(p)), middleDistance(p));
}

// The share of the ball in the colour at p, from 0 to 1. step(x, y) is 1 if x <= y, otherwise 0.
float ballShare(vec3 p)
{
    float a = blockDistance(p), b = ballDistance(p);
    if (operation == 0)
        return step(b, a); // the smaller distance forms the surface
    if (operation == 1)
        return step(a, b); // the larger distance forms the surface
    if (operation == 2)
        return step(a, -b); // the larger of a and -b forms the surface
    return smoothUnionShare(a, b, blend);
}

vec3 middleColour(vec3 p)
{
    vec3 block = hsvToRGB(BLOCK_HUE, saturation, value);
    vec3 ball = hsvToRGB(BALL_HUE, saturation, value);
    return mix(block, ball, ballShare(p));
}

// The colour of the wheel at p: each hue extends 15 degrees on either side of its solid. On the
// axis, where atan is undefined, there is no wheel, and the colour is not used.
vec3 wheelColour(vec3 p)
{
    float angle = degrees(atan(p.z, p.x));
    return hsvToRGB(30.0 * floor(angle / 30.0 + 0.5) + hueShift, saturation, value);
}

// The colour of the surface at p, computed once, where the march has ended.
vec3 colourAt(vec3 p)
{
    float stage = stageDistance(p), wheel = wheelDistance(p), middle = middleDistance(p);
    if (stage < min(wheel, middle))
        return STAGE_COLOUR;
    return wheel < middle ? wheelColour(p) : middleColour(p);
}

// The light of a ray that hits nothing: a dark room, brightest towards GLOW.
vec3 skyLight(vec3 direction)
{
    float towards = max(0.5 + 0.5 * dot(direction, GLOW), 0.0);
    return mix(vec3(0.006, 0.012, 0.026), vec3(0.060, 0.140, 0.180), pow(towards, 6.0));
}

// The light that arrives at p: the light of the sun where the sun is visible, and the light of the
// sky, which is strongest on a face that points up.
vec3 receivedLight(vec3 p, vec3 normal)
{
    Ray ray = shadowRay(p, normal, SUN, 8.0 * hitThreshold);
    float far = shadowReach(normal, SUN, boxInterval(ray, LOW, HIGH).y);
    float seen = lightReaching(ray, far, hitThreshold, maxSteps);
    return seen * lambert(normal, SUN) * SUN_LIGHT + (0.5 + 0.5 * normal.y) * SKY_LIGHT;
}

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        light = colourAt(p) * receivedLight(p, normalAt(p, normalStep));
    }
    return encodeSRGB(light);
}
