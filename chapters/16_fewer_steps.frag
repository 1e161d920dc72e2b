// 16 Fewer steps: one scene marched with two methods, and the steps of both in colour.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "cone.glsl"       // perspectiveRay, pixelSpread
#include "relaxed.glsl"    // marchRelaxed
#include "stretch.glsl"    // twistStretchAlong
#include "transform.glsl"  // opTwist, twistStretch
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox
#include "repetition.glsl" // opRepeatLimited
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach, lightReaching
#include "bounds.glsl"     // boxInterval, intervalUnion
#include "coarse.glsl"     // coarseStart

uniform float lit;          // 0 in [0, 1] step 0.05, widths of the picture: left of it the scene is shown in sunlight instead of its steps
uniform float divider;      // 0.5 in [0, 1] step 0.05, widths of the picture: left of it the scene is marched as before, right of it with the methods below
uniform float far;          // 150 in [20, 100000] step *1.5, scene units: a ray that has travelled this far meets the sky, on both sides
uniform bool  boxes;        // true: march only in the boxes around the pier and the poles
uniform float footprint;    // 1 in [0, 4] step 0.25, half pixels: how fast the threshold grows along the ray
uniform float omega;        // 1.2 in [1, 1.95] step 0.05, distances: length of a step
uniform bool  along;        // true: each ray has its own stretch for the twisted poles
uniform int   maxSteps;     // 256 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

// The pier runs along z and is symmetric about the plane x = 0. The water is the plane y = SEA,
// whose intersection with a ray takes one division; it is not part of the distance.
const float SEA = -1.1;
const vec3  LOW = vec3(-4.3, -1.2, -49.0), HIGH = vec3(4.3, 7.1, 7.9); // corners of a box around the pier
const vec3  POLES_LOW = vec3(3.9, -1.5, -36.0), POLES_HIGH = vec3(4.7, 2.2, 1.0); // box around the poles on one side
const float TWIST = 3.0;                         // twist of a pole, radians per scene unit
const float POLE_REACH = 0.28;                   // radius of the cylinder in which the twist is evaluated, scene units
const vec3  TO_SUN = vec3(-0.4933, 0.6972, 0.5202);
const vec3  SUN_COLOUR = vec3(1.55, 1.38, 1.10); // linear RGB
const vec3  SKY_COLOUR = vec3(0.26, 0.42, 0.55);
const vec3  WATER_COLOUR = vec3(0.05, 0.30, 0.32);

// The divisor of a pole's distance: a stretch that is safe for all rays, or only for the ray that is
// being marched.
float poleStretch;

Ray pixelRay(vec2 screen)
{
    poleStretch = twistStretch(TWIST, POLE_REACH);
    return perspectiveRay(screen);
}

// A bar with a square cross-section; p is relative to its centre.
float bar(vec3 p, float width, float height)
{
    return sdBox(p, vec3(width, height, width));
}

// The walk, its rails and their posts, the piles, and the masts with lanterns, for x >= 0.
float pierDistance(vec3 p)
{
    float deck = sdBox(p - vec3(0.0, -0.06, -16.5), vec3(1.4, 0.06, 24.0));
    vec3 q = p - vec3(1.3, 0.0, -16.5);
    float rails = min(sdBox(q - vec3(0.0, 0.95, 0.0), vec3(0.045, 0.025, 24.0)),
                      sdBox(q - vec3(0.0, 0.5, 0.0), vec3(0.012, 0.012, 24.0)));
    float posts = bar(vec3(q.x, q.y - 0.46, opRepeatLimited(q.z, 1.5, -16.0, 16.0)), 0.03, 0.46);
    float piles = bar(vec3(q.x, q.y + 0.7, opRepeatLimited(q.z, 4.5, -5.0, 5.0)), 0.08, 0.6);
    vec3 mast = vec3(q.x, q.y - 1.3, opRepeatLimited(q.z - 2.25, 9.0, -2.0, 2.0));
    float lantern = sdSphere(mast - vec3(0.0, 1.45, 0.0), 0.15);
    return min(min(deck, rails), min(min(posts, piles), min(bar(mast, 0.025, 1.3), lantern)));
}

// The pavilion at the end of the pier: a roof on slender columns, and a cupola on the roof. The
// distance is a lower bound.
float pavilionDistance(vec3 p)
{
    vec3 q = p - vec3(0.0, 0.0, -44.5);
    float columns = bar(vec3(opRepeatLimited(q.x, 1.2, -3.0, 3.0), q.y - 1.6, abs(q.z) - 3.6), 0.08, 1.7);
    float aside = max(q.x, abs(q.z));
    float roof = max(0.83 * (aside - 4.2 + 1.2 * (q.y - 3.3)) / 1.3, 3.3 - q.y);
    float top = max(roof, q.y - 6.0);
    float cupola = sdBox(q - vec3(0.0, 6.3, 0.0), vec3(0.5, 0.6, 0.5));
    return min(min(columns, cupola), min(sdBox(q - vec3(0.0, -0.06, 0.0), vec3(4.2, 0.06, 4.2)), top));
}

// Mooring poles, for x >= 0: twisted square bars with a ball on top. The twist is evaluated only
// near the axis of a pole; farther away, a cylinder around the pole is enough.
float polesDistance(vec3 p)
{
    vec3 q = vec3(p.x - 4.3, p.y - 0.2, opRepeatLimited(p.z, 7.0, -5.0, 0.0));
    float across = length(q.xz);
    float round = max(across - 0.17, abs(q.y) - 1.6);
    float turned = sdBox(opTwist(q, TWIST), vec3(0.12, 1.6, 0.12)) / poleStretch;
    float pole = across < POLE_REACH ? max(turned, round) : round;
    return min(pole, sdSphere(q - vec3(0.0, 1.72, 0.0), 0.16));
}

float sceneDistance(vec3 p)
{
    vec3 q = vec3(abs(p.x), p.yz);
    return min(min(pierDistance(q), pavilionDistance(q)), polesDistance(q));
}

// The camera stops in front of the pier and above the water.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y - SEA) - 0.08;
}

// ---- Where to march, and how ----

// The interval in which a ray can hit something. It covers a box for the pier and one for the poles
// on each side.
vec2 boxesInterval(Ray ray)
{
    vec3 mirror = vec3(-1.0, 1.0, 1.0), other = mirror * POLES_LOW, opposite = mirror * POLES_HIGH;
    vec2 poles = intervalUnion(boxInterval(ray, POLES_LOW, POLES_HIGH),
                               boxInterval(ray, min(other, opposite), max(other, opposite)));
    return intervalUnion(boxInterval(ray, LOW, HIGH), poles);
}

// The largest distance that counts as a hit at t, on either side of the divider.
float coarseMargin(float t)
{
    return hitThreshold + footprint * pixelSpread() * t;
}

// March a pixel's ray as before, or with this chapter's methods. The same loop does both, because
// its arguments switch the methods on or off.
//   ground  where the ray meets the water
//   now     true to use this chapter's methods
Hit marchPier(Ray ray, float ground, bool now)
{
    float last = min(ground, far), spread = now ? footprint * pixelSpread() : 0.0;
    vec2 interval = now && boxes ? boxesInterval(ray) : vec2(0.0, last);
    float first = now ? max(interval.x, coarseStart(ray)) : interval.x;
    float stretch = poleStretch;
    poleStretch = now && along ? twistStretchAlong(TWIST, POLE_REACH, ray.direction) : stretch;
    Hit hit = marchRelaxed(ray, first, min(interval.y, last), hitThreshold, spread, now ? omega : 1.0, maxSteps);
    poleStretch = stretch;
    return hit;
}

// ---- Colours ----

// The colours go from night blue through violet and rose to straw. Each is lighter than the previous
// one, so that the order is also visible in grey.
vec3 stepColour(int steps)
{
    const vec3 colours[5] = vec3[5](vec3(0.05, 0.04, 0.15), vec3(0.24, 0.16, 0.43), vec3(0.62, 0.27, 0.46),
                                    vec3(0.94, 0.55, 0.37), vec3(1.00, 0.95, 0.72));
    float x = min(float(steps) / 16.0, 3.999);
    int i = int(x);
    return mix(colours[i], colours[i + 1], x - float(i));
}

// A summer sky, pale at the horizon; below the horizon, the colour of distant water.
vec3 skyLight(vec3 direction)
{
    return mix(vec3(0.62, 0.80, 0.82), vec3(0.10, 0.33, 0.62), smoothstep(0.0, 0.5, direction.y));
}

// The lagoon: shallow and clear below the eye, and a mirror farther away.
vec3 waterLight(Ray ray)
{
    float grazing = 1.0 - abs(ray.direction.y), square = grazing * grazing;
    return mix(WATER_COLOUR, 0.9 * skyLight(reflect(ray.direction, vec3(0.0, 1.0, 0.0))), 0.04 + 0.8 * square * square * square);
}

// The colour of a surface point: planks, red and white poles, or white paint.
vec3 paintAt(vec3 p, vec3 normal)
{
    vec3 q = vec3(abs(p.x) - 4.3, p.y - 0.2, opRepeatLimited(p.z, 7.0, -5.0, 0.0)), turned = opTwist(q, TWIST);
    vec3 pole = abs(turned.x) > abs(turned.z) ? vec3(0.62, 0.07, 0.05) : vec3(0.85, 0.82, 0.76);
    vec3 planks = vec3(0.52, 0.42, 0.31) * (0.86 + 0.14 * step(0.5, fract(1.5 * p.z)));
    bool deck = p.y < 0.3 && normal.y > 0.7;
    return abs(p.x) > 3.5 ? pole : (deck ? planks : vec3(0.82, 0.82, 0.80));
}

// The light of a pixel if the scene is shown in sunlight.
//   ground  where the ray meets the water
vec3 sceneLight(Ray ray, Hit hit, float ground)
{
    bool water = !hit.found && ground < far, met = hit.found || water;
    float t = hit.found ? hit.t : min(ground, far), radius = hitThreshold + pixelSpread() * t;
    vec3 p = ray.origin + t * ray.direction;
    vec3 normal = hit.found ? normalAt(p, radius) : vec3(0.0, 1.0, 0.0);
    Ray there = shadowRay(p, normal, TO_SUN, 3.0 * radius);
    float reach = met ? min(shadowReach(normal, TO_SUN, boxesInterval(there).y), 12.0) : 0.0;
    float seen = lightReaching(there, reach, hitThreshold, 64);
    vec3 light = seen * lambert(normal, TO_SUN) * SUN_COLOUR + (0.6 + 0.4 * normal.y) * SKY_COLOUR;
    vec3 matt = hit.found ? paintAt(p, normal) * light : waterLight(ray) * (0.6 + 0.4 * seen);
    vec3 haze = skyLight(vec3(ray.direction.x, 0.0, ray.direction.z));
    return met ? mix(haze, matt, exp(-0.0001 * t * t)) : skyLight(ray.direction);
}

vec3 rayColour(Ray ray)
{
    float ground = ray.direction.y < 0.0 ? (SEA - ray.origin.y) / ray.direction.y : 1e6;
    float fraction = (float(iPixel.x) + 0.5) / iResolution.x;
    Hit hit = marchPier(ray, ground, fraction >= divider);
    int steps = trace.steps;
    if ((VIEW == VIEW_NORMALS || VIEW == VIEW_DEPTH) && trace.end == END_PASSED && ground < far) { // normals and depth: include the water
        traceNormal(vec3(0.0, 1.0, 0.0));
        traceMarch(steps, ground, END_HIT);
    }
    bool sunny = fraction < lit || VIEW == VIEW_NORMALS; // sceneLight computes the normals for their view
    return sunny ? encodeSRGB(sceneLight(ray, hit, ground)) : stepColour(steps);
}
