// 13 Soft shadows: the lamp is a disc, and only a share of it is visible from a point in the
// penumbra.

#include "main.glsl"        // main(): calls pixelRay, then rayColour
#include "cone.glsl"        // perspectiveRay, marchCone, pixelSpread
#include "normal.glsl"      // normalAt
#include "primitives.glsl"  // sdSphere, sdBox
#include "combine.glsl"     // opSmoothUnion
#include "repetition.glsl"  // opRepeatLimited, cellRandom
#include "lighting.glsl"    // lambert, encodeSRGB
#include "soft_shadow.glsl" // clearanceAlong, lampReaching; shadowRay, shadowReach of shadow.glsl
#include "bounds.glsl"      // boxInterval
#include "coverage.glsl"    // stripes, blurred

uniform int   shadow;       // 2 in [0, 3]: 0 hard, 1 from the smallest distance / t, 2 from pairs of steps, 3 with many rays
uniform float spread;       // 0.04 in [0.002, 0.2] step *1.1: radius of the sun's disc at a distance of one unit; the real sun's is 0.0047
uniform int   rays;         // 4 in [1, 8]: rays per side: with shadow 3 each sample sends rays x rays towards the sun
uniform float sunElevation; // 29 in [5, 80] step 1, degrees: height of the sun above the horizon
uniform float sunAzimuth;   // 214 in [0, 360] step 2, degrees: azimuth of the sun, from the right towards the viewer
uniform float sunSpeed;     // 3 in [0, 90] step 1, degrees per second: speed of the sun's azimuth
uniform int   maxSteps;     // 128 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

// The floor is the plane y = 0. It is not part of the distance: a division finds where a ray meets
// it, and a shadow ray that starts on it needs no small steps to leave it.
const vec3  LOW = vec3(-10.1, -0.01, -5.3);         // opposite corners of a box around everything else
const vec3  HIGH = vec3(6.9, 2.78, 2.9);
const float EDGE = -5.2;                            // z at which the floor ends, scene units
const float FAR = 60.0;
const float LONGEST_SHADOW = 10.0;                  // longest shadow with the sun at least 17 degrees high, scene units
const vec3  SUN_COLOUR = vec3(1.40, 0.95, 0.55);    // light of the sun on a surface that faces it, linear RGB
const vec3  SKY_COLOUR = vec3(0.38, 0.55, 0.75);    // light from above; fitted to paths, like the next
const vec3  EARTH_COLOUR = vec3(0.80, 0.68, 0.58);  // light from below: from the horizon and the floor
const vec3  STONE = vec3(0.80, 0.76, 0.70);
const vec3  SANDSTONE = vec3(0.62, 0.55, 0.46);     // of the steps: dark enough for the sun on their risers
const vec4  BALL = vec4(0.1, 0.42, -1.7, 0.42);     // centre and radius
const float PAVING = 0.9;                           // side of a paving stone, scene units
const float JOINT = 0.014;                          // width of a joint, in paving stones

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// A row of slender posts under a beam.
float trellisDistance(vec3 p)
{
    vec3 q = p - vec3(-2.9, 1.3, 0.0);
    float posts = sdBox(vec3(q.xy, opRepeatLimited(q.z, 0.6, -7.0, 4.0)), vec3(0.04, 1.3, 0.04));
    return min(posts, sdBox(q - vec3(0.0, 1.37, -0.9), vec3(0.09, 0.07, 3.7)));
}

// A slender figure on a plinth: a body that tapers upwards, shoulders, a neck and a head. The
// distance is a lower bound.
float figureDistance(vec3 p)
{
    vec3 q = p - vec3(1.45, 0.0, 0.1);
    float height = clamp(q.y, 0.2, 1.6);
    float taper = mix(0.16, 0.04, (height - 0.2) / 1.4);
    float body = 0.995 * (length(q - vec3(0.0, height, 0.0)) - taper); // the taper's slope is 0.086
    float shoulders = sdSphere(q - vec3(0.0, 1.40, 0.0), 0.115);
    float head = sdSphere(q - vec3(0.0, 1.76, 0.0), 0.1);
    float plinth = sdBox(q - vec3(0.0, 0.1, 0.0), vec3(0.24, 0.1, 0.24));
    float figure = opSmoothUnion(opSmoothUnion(body, shoulders, 0.25), head, 0.14);
    return min(plinth, figure);
}

// Three steps; each is a box whose lower half is in the ground.
float stairDistance(vec3 p)
{
    vec3 q = p - vec3(4.5, 0.0, -3.0), move = vec3(0.45, 0.0, -0.2);
    float lower = min(sdBox(q, vec3(1.9, 0.2, 1.9)), sdBox(q - move, vec3(1.9, 0.4, 1.7)));
    return min(lower, sdBox(q - 2.0 * move, vec3(1.9, 0.6, 1.5)));
}

float sceneDistance(vec3 p)
{
    float parapet = sdBox(p - vec3(0.0, 0.2, -5.1), vec3(10.0, 0.2, 0.15));
    float ball = sdSphere(p - BALL.xyz, BALL.w);
    float slender = min(trellisDistance(p), figureDistance(p));
    return min(min(parapet, ball), min(slender, stairDistance(p)));
}

// The camera stops in front of the objects and above the floor.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y) - 0.1;
}

vec3 sunDirection()
{
    float azimuth = radians(sunAzimuth + sunSpeed * iTime), elevation = radians(sunElevation);
    return vec3(cos(elevation) * vec2(cos(azimuth), sin(azimuth)), sin(elevation)).xzy;
}

// Pale paving with thin joints.
//   width  of the pixel on the floor, along x and z
vec3 floorColour(vec3 p, vec2 width)
{
    vec2 tile = p.xz / PAVING, across = width / PAVING;
    float alongZ = mix(stripes(tile.x, JOINT, across.x), JOINT, blurred(across.x));
    float alongX = mix(stripes(tile.y, JOINT, across.y), JOINT, blurred(across.y));
    float tone = cellRandom(ivec3(floor(tile.x + 0.5), floor(tile.y + 0.5), 3));
    return STONE * (0.94 + 0.1 * tone) * (1.0 - 0.35 * max(alongZ, alongX));
}

// The sky is peach above the horizon and pale blue higher up; the sea is below the horizon.
vec3 skyLight(vec3 direction, vec3 toSun)
{
    float facing = 0.5 + 0.5 * dot(direction, toSun);
    vec3 peach = mix(vec3(0.95, 0.72, 0.60), vec3(1.0, 0.78, 0.55), facing * facing);
    vec3 sky = mix(peach, vec3(0.34, 0.54, 0.78), smoothstep(0.0, 0.42, direction.y));
    vec3 sea = mix(vec3(0.45, 0.60, 0.68), vec3(0.72, 0.70, 0.68), smoothstep(-0.12, 0.0, direction.y));
    return mix(sea, sky, smoothstep(-0.002, 0.002, direction.y));
}

// ---- Where a ray ends, and how much of the sun is visible from there ----

// Where the ray of a pixel ends.
struct Surface {
    bool  open;   // the ray met only the sky
    vec3  p;      // scene units
    vec3  normal; // length 1
    vec3  colour;
    float radius; // radius of the pixel's footprint at p
};

Surface surfaceAt(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    float ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : FAR;
    Hit hit = marchCone(ray, interval.x, min(interval.y, ground), hitThreshold, pixelSpread(), maxSteps);
    float t = hit.found ? hit.t : min(ground, FAR);
    vec3 p = ray.origin + t * ray.direction;
    float radius = hitThreshold + pixelSpread() * t;
    vec2 width = 2.0 * radius * (1.0 + abs(ray.direction.xz / ray.direction.y));
    vec3 normal = hit.found ? normalAt(p, radius) : vec3(0.0, 1.0, 0.0);
    bool open = !hit.found && (t >= FAR || p.z < EDGE);
    if (!hit.found && !open) { // the floor: report the hit to the views and the probe
        traceMarch(trace.steps, t, END_HIT);
        traceNormal(normal);
    }
    vec3 stone = p.x > 2.5 && p.z > -4.92 ? SANDSTONE : STONE;
    return Surface(open, p, normal, hit.found ? stone : floorColour(p, width), radius);
}

// The shadow ray from a point to the centre of the sun.
Ray sunRay(Surface surface, vec3 toSun)
{
    return shadowRay(surface.p, surface.normal, toSun, 2.0 * surface.radius);
}

// How far to march along the shadow ray: to where it leaves the box. The box is enlarged by the
// greatest distance between the rays to the sun's centre and to its rim.
float sunReach(Surface surface, Ray ray)
{
    float room = LONGEST_SHADOW * spread;
    return surface.open ? 0.0 : shadowReach(surface.normal, ray.direction, boxInterval(ray, LOW - room, HIGH + room).y);
}

// The visible share of the sun, computed with one of four methods.
float sunSeen(Surface surface, vec3 toSun)
{
    Ray ray = sunRay(surface, toSun);
    float far = sunReach(surface, ray);
    bool many = shadow == 3;
    Clearance clearance = clearanceAlong(ray, 0.0, many ? 0.0 : far, hitThreshold, maxSteps);
    float arrived = lampReaching(ray, far, spread, many ? rays : 0, hitThreshold, maxSteps, 0);
    float quick = min((shadow == 1 ? clearance.most : clearance.least) / spread, 1.0);
    float hard = clearance.most > 0.0 ? 1.0 : 0.0;
    return many ? arrived : (shadow == 0 ? hard : quick);
}

// The light of everything but the sun.
vec3 ambientLight(vec3 normal)
{
    return mix(EARTH_COLOUR, SKY_COLOUR, 0.5 + 0.5 * normal.y);
}

// The light that reaches the eye. The shadow darkens only the sun's light.
vec3 surfaceLight(Surface surface, Ray ray, vec3 toSun, float seen)
{
    vec3 light = ambientLight(surface.normal) + seen * lambert(surface.normal, toSun) * SUN_COLOUR;
    return surface.open ? skyLight(ray.direction, toSun) : surface.colour * light;
}

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface surface = surfaceAt(ray);
    return encodeSRGB(surfaceLight(surface, ray, toSun, sunSeen(surface, toSun)));
}
