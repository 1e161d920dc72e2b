// 23 Stored distances: a clay elephant on a turntable. The distance to it was computed once, from 25,600 triangles, and
// is stored in a grid.

#include "main.glsl"        // main(): calls pixelRay, then rayColour
#include "cone.glsl"        // perspectiveRay, marchCone, coneReaching, pixelSpread
#include "coarse.glsl"      // coarseStart
#include "bounds.glsl"      // boxInterval
#include "normal.glsl"      // normalAt
#include "plane.glsl"       // sdRectangle
#include "transform.glsl"   // rotationY
#include "stored.glsl"      // storedDistance, storedStep
#include "occlusion.glsl"   // tapHeight, skyAndBounces; shadowRay, shadowReach of shadow.glsl
#include "gloss.glsl"       // ggxGloss, halfway
#include "fresnel.glsl"     // schlickShare
#include "noise.glsl"       // gradientNoise
#include "lighting.glsl"    // lambert, encodeSRGB
#include "film.glsl"        // filmOfLargest, ditherStep

uniform sampler3D grid; // "clay.png" linear clamp 64: the distance to the elephant, high and low byte

uniform int   stepping;     // 2 in [0, 2]: length of a step: 0 the stored value, 1 that value / sqrt(3), 2 storedStep
uniform float tool;         // 0 in [-0.2, 0.2] step 0.01, scene units: radius of the roll of clay that a drag adds; below 0 a drag removes clay, at 0 it turns the view
uniform float turn;         // 52 in [-360, 360] step 2, degrees: angle of the turntable at the start
uniform float turnSpeed;    // 12 in [-90, 90] step 2, degrees per second: speed of the turntable
uniform float normalStep;   // 1 in [0.02, 3] step 0.05, cells: step of the differences for the normal
uniform float grain;        // 1 in [0, 4] step 0.25: how uneven the clay is
uniform bool  eyes;         // true: paint the elephant's eyes
uniform float exposure;     // 0 in [-4, 4] step 0.25, stops: each doubles the light
uniform int   maxSteps;     // 128 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.001 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

// The grid is the cube from -1 to 1. The elephant stands on a turntable, and the turntable on a table, the plane
// y = TABLE. A division finds where a ray meets this plane.
const float TOP = -0.562, TABLE = -0.78;
const vec3  LOW = vec3(-1.1, TABLE, -1.1), HIGH = vec3(1.1, 0.9, 1.1); // box around the elephant and the turntable
const float FAR = 40.0;
const float CONE = 0.012;                            // radius of the cone of a shadow ray where it starts
const vec3  TO_KEY = vec3(-0.7428, 0.5571, 0.3714);   // direction of the large lamp on the left, length 1
const vec3  TO_RIM = vec3(0.6805, 0.3889, -0.6211);   // direction of the lamp behind the elephant, on the right
const vec3  KEY_COLOUR = vec3(3.6, 2.95, 2.25);       // light on a surface that faces the lamp, linear RGB
const vec3  RIM_COLOUR = vec3(1.3, 1.8, 2.4);
const vec3  FILL_COLOUR = vec3(0.18, 0.24, 0.30);     // light from above
const vec3  BOUNCE_COLOUR = vec3(0.10, 0.075, 0.06);   // light from below
const vec3  CLAY = vec3(0.36, 0.115, 0.05);
const vec3  IRON = vec3(0.045, 0.05, 0.055);
const vec3  PAPER = vec3(0.032, 0.062, 0.072);         // colour of the table and the backdrop
const vec3  EYE = vec3(0.148, 0.259, 0.422);         // one eye, in the elephant's coordinates; the other is at -x

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// ---- Distances ----

// Map a point of the scene to the elephant's coordinates by turning the turntable back.
vec3 onTurntable(vec3 p)
{
    return rotationY(-radians(turn + turnSpeed * iTime)) * p;
}

// The length of a step towards the clay.
float clayDistance(vec3 p)
{
    float value = storedDistance(grid, onTurntable(p));
    return stepping == 2 ? storedStep(value) : (stepping == 1 ? 0.5773502 * value : value);
}

// A disc with a rounded rim on a foot: a figure of two rectangles, revolved about the axis.
float turntableDistance(vec3 p)
{
    vec2 q = vec2(length(p.xz), p.y - TOP);
    float disc = sdRectangle(q + vec2(0.0, 0.035), vec2(1.03, 0.02)) - 0.015;
    return min(disc, sdRectangle(q + vec2(0.0, 0.14), vec2(0.38, 0.07)) - 0.01);
}

float sceneDistance(vec3 p)
{
    return min(clayDistance(p), turntableDistance(p));
}

// The camera stops in front of the clay and above the table.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y - TABLE) - 0.05;
}

// A step is at least the distance / sqrt(3), so with this threshold outlines grow by at most half a pixel.
float coarseMargin(float t)
{
    return hitThreshold + 0.5773502 * pixelSpread() * t;
}

// ---- Surfaces ----

struct Surface {
    vec3  p, normal;
    vec3  colour;    // share of the light that is scattered, linear RGB
    float roughness;
    float mirror;    // share of the light that is reflected at normal incidence
};

// Clay: uneven in colour and height, with two dark eyes.
Surface clayAt(vec3 p, vec3 normal)
{
    vec3 q = onTurntable(p), eye = vec3(abs(q.x), q.yz) - EYE;
    vec4 fine = gradientNoise(9.0 * q);
    vec3 slope = rotationY(radians(turn + turnSpeed * iTime)) * fine.yzw;
    vec3 bumped = normalize(normal - 0.02 * grain * (slope - dot(slope, normal) * normal));
    vec3 colour = CLAY * (1.0 + grain * 0.12 * fine.x);
    bool pupil = eyes && dot(eye, eye) < 0.0011;
    return Surface(p, pupil ? normal : bumped, pupil ? vec3(0.012) : colour, pupil ? 0.18 : 0.62, 0.04);
}

// The turntable, which is iron with fine rings, or the table, which is paper.
Surface standAt(vec3 p, vec3 normal, bool table)
{
    float ring = 0.5 + 0.5 * sin(150.0 * length(p.xz));
    vec3 iron = IRON * (0.85 + 0.3 * ring);
    return Surface(p, normal, table ? PAPER : iron, table ? 0.9 : 0.42, table ? 0.02 : 0.22);
}

// ---- Light ----

// The light of one lamp that a surface sends to the eye.
vec3 lampLight(Surface s, vec3 toEye, vec3 toLamp, vec3 colour, float seen)
{
    float gloss = ggxGloss(s.normal, toLamp, toEye, s.roughness);
    float share = schlickShare(max(dot(toEye, halfway(toLamp, toEye)), 0.0), s.mirror);
    return seen * lambert(s.normal, toLamp) * colour * (s.colour + share * gloss);
}

// The light of the paper behind the table: a bright spot that fades outwards.
vec3 backdrop(vec2 screen)
{
    float away = length((screen - vec2(-0.35, 0.28)) * vec2(0.72, 1.0));
    return PAPER * (0.10 + 1.35 * exp(-1.1 * away * away));
}

// The openness of a point, estimated as by openByTaps but from three distances instead of five.
float openAt(vec3 p, vec3 normal)
{
    float hidden = 0.0;
    for (int k = 0; k < 3; k++) {
        float height = tapHeight(k + TAPS - 3, 0.36);
        hidden += clamp(1.0 - distanceAt(p + height * normal) / height, 0.0, 1.0);
    }
    return max(1.0 - 0.8 * hidden / 3.0, 0.0);
}

vec3 surfaceLight(Surface s, vec3 toEye)
{
    // The cone starts where it touches nothing yet: a step is at least the distance / sqrt(3).
    Ray toKey = shadowRay(s.p, s.normal, TO_KEY, 1.7320508 * CONE);
    vec2 box = boxInterval(toKey, LOW, HIGH);
    float far = shadowReach(s.normal, TO_KEY, box.y);
    float seen = coneReaching(toKey, box.x, far, CONE, 0.16, 48);
    float open = openAt(s.p, s.normal);
    vec3 sky = mix(BOUNCE_COLOUR, FILL_COLOUR, 0.5 + 0.5 * s.normal.y);
    vec3 light = s.colour * sky * skyAndBounces(open, s.colour, 2);
    light += lampLight(s, toEye, TO_KEY, KEY_COLOUR, seen);
    return light + lampLight(s, toEye, TO_RIM, RIM_COLOUR, open * open);
}

vec3 developed(vec3 light)
{
    return encodeSRGB(filmOfLargest(exp2(exposure) * light, 1.25, 6.0)) + ditherStep(iPixel) / 255.0;
}

vec3 rayColour(Ray ray)
{
    float ground = ray.direction.y < 0.0 ? min((TABLE - ray.origin.y) / ray.direction.y, FAR) : FAR;
    vec2 box = boxInterval(ray, LOW, HIGH);
    Hit hit = marchCone(ray, max(box.x, coarseStart(ray)), min(box.y, ground), hitThreshold, 0.5773502 * pixelSpread(), maxSteps);
    float t = hit.found ? hit.t : ground, radius = hitThreshold + pixelSpread() * t;
    vec3 p = ray.origin + t * ray.direction;
    bool clay = hit.found && turntableDistance(p) > 2.0 * radius;
    vec3 normal = hit.found ? normalAt(p, clay ? normalStep * STORED_CELL : radius) : vec3(0.0, 1.0, 0.0);
    Surface surface = standAt(p, normal, !hit.found);
    if (clay)
        surface = clayAt(p, normal);
    vec3 light = surfaceLight(surface, -ray.direction);
    vec2 screen = screenPosition(vec2(iPixel) + 0.5);
    float fade = hit.found ? 0.0 : smoothstep(3.0, 8.0, t);
    return developed(mix(light, backdrop(screen), fade));
}
