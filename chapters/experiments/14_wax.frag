// Experiment of chapter 14: three candles and a sprig of leaves on a sill, at dusk. The light that
// shines through wax and leaf comes from the flames, and is weakened along its path inside.
#include "main.glsl"
#include "bounds.glsl"
#include "combine.glsl"
#include "cone.glsl"
#include "lighting.glsl"
#include "normal.glsl"
#include "occlusion.glsl"
#include "primitives.glsl"
#include "solids.glsl"
#include "thickness.glsl"

uniform bool  through;      // true: wax and leaf transmit light
uniform float clearness;    // 1 in [0.1, 10] step *1.1: depth that light reaches, relative to that of wax and leaf
uniform int   inside;       // 0 in [0, 1]: path inside: 0 along the ray to the flame, 1 estimated from five distances below the surface
uniform int   maxSteps;     // 96 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

const vec4 CANDLES[3] = vec4[3](vec4(-0.95, 1.30, -0.10, 0.27), vec4(-0.32, 0.78, 0.28, 0.30), vec4(0.28, 1.02, -0.38, 0.25)); // x, height, z, radius
const vec3 FLAME = vec3(2.3, 1.25, 0.42);             // light of a flame at the distance REFERENCE, linear RGB
const vec3 DUSK = vec3(0.10, 0.15, 0.25);             // light of the sky on an open floor
const vec3 WAX = vec3(0.82, 0.74, 0.60), WAX_DEPTH = vec3(0.42, 0.20, 0.085);
const vec3 LEAF = vec3(0.10, 0.20, 0.05), LEAF_DEPTH = vec3(0.035, 0.075, 0.012);
const vec3 SLATE = vec3(0.34, 0.31, 0.30);
const vec3 CLAY = vec3(0.50, 0.22, 0.12);
const float REFERENCE = 0.60;                         // scene units
const float WALL = -1.5;                              // z of the wall

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float waxDistance(vec3 p)
{
    float nearest = 100.0;
    for (int i = 0; i < 3; i++) {
        vec4 c = CANDLES[i];
        vec3 q = p - vec3(c.x, 0.5 * c.y, c.z);
        nearest = min(nearest, sdCylinder(q, c.w - 0.05, 0.5 * c.y - 0.05) - 0.05);
    }
    return nearest;
}

// A leaf: the intersection of two balls, stretched along its midline.
//   along, face  directions of the midline and of the normal of the leaf, length 1
float leafDistance(vec3 p, vec3 foot, vec3 along, vec3 face)
{
    vec3 q = p - foot - 0.3 * along;
    vec3 local = vec3(0.6 * dot(q, along), dot(q, face), dot(q, cross(along, face)));
    float above = length(local - vec3(0.0, 0.5, 0.0)), below = length(local + vec3(0.0, 0.5, 0.0));
    return opIntersection(above, below) - 0.525;
}

float leavesDistance(vec3 p)
{
    float nearest = sdCapsule(p, vec3(1.10, 0.3, 0.15), vec3(1.02, 1.22, 0.15), 0.014);
    for (int i = 0; i < 6; i++) {
        float turn = 2.4 * float(i) + 0.4;
        vec3 along = normalize(vec3(cos(turn), 0.5 + 0.1 * float(i), 0.5 * sin(turn)));
        vec3 side = normalize(cross(along, vec3(-0.3, 0.5, 0.8)));
        vec3 foot = vec3(1.08 - 0.012 * float(i), 0.5 + 0.14 * float(i), 0.15);
        nearest = min(nearest, leafDistance(p, foot, along, cross(side, along)));
    }
    return nearest;
}

float potDistance(vec3 p)
{
    return sdCappedCone(p - vec3(1.10, 0.17, 0.15), 0.17, 0.23, 0.17) - 0.01;
}

float sceneDistance(vec3 p)
{
    float room = min(p.y, p.z - WALL);
    return min(min(waxDistance(p), leavesDistance(p)), min(potDistance(p), room));
}

// The point that a ray meets, and its material.
struct Spot {
    vec3  p, normal, colour;
    vec3  depth;  // the path inside after which 1 / e of the light is left, scene units; 0 if opaque
    float radius; // radius of the pixel's footprint at p
};

Spot spotAt(Ray ray, float t)
{
    vec3 p = ray.origin + t * ray.direction;
    float radius = hitThreshold + pixelSpread() * t;
    bool wax = waxDistance(p) < radius, leaf = leavesDistance(p) < radius, pot = potDistance(p) < radius;
    vec3 colour = wax ? WAX : (leaf ? LEAF : (pot ? CLAY : SLATE));
    return Spot(p, normalAt(p, radius), colour, wax ? WAX_DEPTH : (leaf ? LEAF_DEPTH : vec3(0.0)), radius);
}

// The length of the path inside wax or leaf towards a lamp, or an estimate of this length from five
// distances below the surface.
float wayInside(Spot spot, vec3 toLamp, float far)
{
    float sum = 0.0;
    for (int k = 0; k < TAPS; k++)
        sum += max(-distanceAt(spot.p - tapHeight(k, 0.4) * spot.normal), 0.0);
    vec3 below = spot.p - 2.0 * spot.radius * spot.normal;
    return inside == 1 ? sum : thicknessAlong(Ray(below, toLamp), far, 0.0005, 64);
}

// The light of one flame at a spot, reflected and transmitted. The flame casts no shadows.
vec3 flameLight(Spot spot, vec3 flame)
{
    float far = length(flame - spot.p);
    vec3 toFlame = (flame - spot.p) / far;
    vec3 left = lightThrough(wayInside(spot, toFlame, far), max(clearness * spot.depth, 1e-4));
    vec3 on = lambert(spot.normal, toFlame) * spot.colour;
    bool lets = through && spot.depth.x > 0.0;
    return fallOff(far, REFERENCE) * FLAME * (on + (lets ? 0.22 * left : vec3(0.0)));
}

// The flame itself, an upright ellipsoid, and the glow of the air around it.
//   far  t at which the ray ends, scene units
vec3 flameSeen(Ray ray, vec3 flame, float far)
{
    vec3 squeeze = vec3(1.0, 0.4, 1.0), from = squeeze * (ray.origin - flame), along = squeeze * ray.direction;
    float t = -dot(from, along) / dot(along, along), near = length(from + t * along);
    vec3 core = vec3(5.0, 3.3, 1.5) * (1.0 - smoothstep(0.016, 0.040, near));
    return t < far ? core + 0.035 * FLAME * exp(-6.0 * near) : vec3(0.0);
}

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, vec3(-40.0, -0.01, WALL - 0.01), vec3(40.0, 40.0, 9.0));
    Hit hit = marchCone(ray, interval.x, interval.y, hitThreshold, pixelSpread(), maxSteps);
    Spot spot = spotAt(ray, hit.t);
    vec3 light = spot.colour * DUSK * openByTaps(spot.p, spot.normal, 1.0, 1.0);
    for (int i = 0; i < 3; i++) {
        vec3 flame = CANDLES[i].xyz + vec3(0.0, 0.13, 0.0);
        light += flameLight(spot, flame) + flameSeen(ray, flame, hit.t);
    }
    return encodeSRGB(light);
}
