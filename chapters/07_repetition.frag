// 07 Repetition: folding each point into the cell of one lantern gives an endless field of
// lanterns, no two alike.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread
#include "primitives.glsl" // for the exercises: sdSphere, sdBox, sdBoxFrame
#include "lighting.glsl"   // lambert, fallOff, encodeSRGB
#include "hue.glsl"        // hsvToRGB
#include "repetition.glsl" // cellOf, cellOthers, cellRandom

uniform float period;       // 5.5 in [3, 10] step 0.25, scene units: width of a cell along x and z
uniform float variety;      // 1 in [0, 1] step 0.05: how much the lanterns differ; at 0 all are alike
uniform bool  capped;       // true: no step is longer than the distance to the other cells' lanterns
uniform float fogDistance;  // 26 in [4, 80] step 1, scene units: where 1/e of the light is left in the mist
uniform float drift;        // 0.5 in [0, 5] step 0.25, scene units per second: how fast the eye moves
uniform int   maxSteps;     // 160 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.001 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit, at the eye

const float FAR = 38.0;                          // beyond this distance only mist is visible
const float FADE = 12.0;                         // over the last 12 units before FAR, the light fades
const float LOW = 0.15;                          // the lanterns hang between these two heights
const float HIGH = 2.95;
const vec3  BODY = vec3(0.5, 0.7, 0.5);          // half size of a frame of size 1
const float BALL = 0.34;                         // radius of the ball in a frame of size 1
const float BAR = 0.05;                          // radius of a frame's bars
const float SIZE = 1.15;                         // size of the largest lantern
const float REFERENCE = 2.0;                     // distance at which the fall-off of a lantern of size 1 is 1
const vec3  METAL = vec3(0.50, 0.44, 0.42);      // colours, linear RGB
const vec3  GROUND = vec3(0.13, 0.14, 0.19);
const vec3  ZENITH = vec3(0.012, 0.020, 0.075);
const vec3  HAZE = vec3(0.06, 0.042, 0.09);
const vec3  GLOW = vec3(0.95, 0.36, 0.12);
const vec3  SUNSET = vec3(-0.384, 0.030, -0.923); // direction of the sunset, length 1

struct Lantern {
    vec3  local; // position of the point, relative to the lantern's centre, scene units
    float size;
    float hue;   // degrees
};

// The lantern of the cell that contains p. One random number serves as three: all of its bits,
// those after the first 6, and those after the first 12.
Lantern lanternAt(vec3 p)
{
    vec2 cell = vec2(cellOf(p.x, period), cellOf(p.z, period));
    float random = cellRandom(ivec3(cell.x, 0, cell.y));
    float height = 1.55 + variety * (random - 0.5);
    vec3 local = p - vec3(period * cell.x, height, period * cell.y);
    float size = SIZE - 0.4 * variety * fract(64.0 * random);
    return Lantern(local, size, 25.0 + 300.0 * variety * fract(4096.0 * random));
}

float ballDistance(Lantern lantern)
{
    return length(lantern.local) - BALL * lantern.size;
}

// The distance to a frame of twelve round bars: the distance to the nearest edge of the box, minus
// the radius of a bar. It is exact outside the bars. Between the ends of the nearest edge, the
// difference along that edge does not count.
float frameDistance(Lantern lantern)
{
    vec3 corner = abs(lantern.local) - lantern.size * BODY;
    vec3 free = min(corner, 0.0);
    free *= free;
    return sqrt(dot(corner, corner) - max(free.x, max(free.y, free.z))) - BAR;
}

// The normal of a lantern, length 1: it points away from the ball's centre, or from the nearest
// edge. The function evaluates only the copy that was hit, not the whole scene six times.
vec3 lanternNormal(Lantern lantern, bool ball)
{
    vec3 corner = abs(lantern.local) - lantern.size * BODY;
    float most = min(corner.x, min(corner.y, corner.z));
    bvec3 free = lessThanEqual(corner, vec3(min(most, 0.0)));
    vec3 fromEdge = sign(lantern.local) * mix(corner, vec3(0.0), free);
    return normalize(ball ? lantern.local : fromEdge);
}

Ray pixelRay(vec2 screen)
{
    Ray ray = perspectiveRay(screen);
    ray.origin.z -= drift * iTime;
    return ray;
}

float sceneDistance(vec3 p)
{
    Lantern lantern = lanternAt(p);
    float own = min(ballDistance(lantern), frameDistance(lantern));
    float reach = SIZE * BODY.x + BAR;
    float others = min(cellOthers(p.x, period, reach), cellOthers(p.z, period, reach));
    return capped ? min(own, others) : own;
}

// The camera stops above the ground. It passes through the lanterns, because they drift past it.
float cameraRoom(vec3 p)
{
    return p.y - 0.1;
}

// The light of the sky from a direction: an afterglow above the horizon. The mist has the same
// colour.
vec3 skyLight(vec3 direction)
{
    float low = exp(-6.0 * max(direction.y, 0.0));
    float towards = max(dot(direction, SUNSET), 0.0);
    float square = towards * towards;
    float glow = square * square;
    return mix(ZENITH, HAZE, low) + low * low * (0.05 + 0.1 * towards + 0.55 * glow * glow) * GLOW;
}

// The light that a surface receives: the light of the lantern in its cell, which fades out towards
// the walls of the cell, and the light of the dusk.
vec3 receivedLight(Lantern lantern, vec3 normal)
{
    float distance = length(lantern.local);
    vec2 fade = 1.0 - smoothstep(0.2, 0.5, abs(lantern.local.xz) / period);
    float share = lambert(normal, -lantern.local / distance) * fade.x * fade.y;
    vec3 colour = hsvToRGB(lantern.hue, 0.75, 1.0) * fallOff(distance, REFERENCE * lantern.size);
    vec3 dusk = mix(0.3 * HAZE, ZENITH + 0.5 * HAZE, 0.5 + 0.5 * normal.y);
    return share * colour + dusk + 0.25 * lambert(normal, SUNSET) * GLOW;
}

// The light of the glowing ball, brighter and paler where the surface faces the eye.
vec3 ballLight(Lantern lantern, float facing)
{
    return mix(0.8, 1.9, facing) * hsvToRGB(lantern.hue, mix(0.9, 0.4, facing * facing), 1.0);
}

// The light from the lantern or the ground that the ray hits at p.
vec3 surfaceLight(Ray ray, vec3 p, bool found)
{
    Lantern lantern = lanternAt(p);
    bool ball = found && ballDistance(lantern) < frameDistance(lantern);
    vec3 normal = found ? lanternNormal(lantern, ball) : vec3(0.0, 1.0, 0.0);
    if (found)
        traceNormal(normal);
    vec3 matt = (found ? METAL : GROUND) * receivedLight(lantern, normal);
    return ball ? ballLight(lantern, abs(dot(normal, ray.direction))) : matt;
}

// The lanterns hang in a slab of air, which a ray crosses from start to end. The ground is below
// the slab.
vec3 rayColour(Ray ray)
{
    vec2 slab = (vec2(LOW, HIGH) - ray.origin.y) / ray.direction.y;
    float start = max(min(slab.x, slab.y), 0.0);
    float end = min(max(slab.x, slab.y), FAR);
    // A surface counts as reached within an eighth of a pixel: a larger share would thicken the bars of the frames.
    Hit hit = marchCone(ray, start, end, hitThreshold, 0.25 * pixelSpread(), maxSteps);
    float ground = ray.origin.y * ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : FAR;
    float t = hit.found ? hit.t : min(ground, FAR);
    vec3 light = surfaceLight(ray, ray.origin + t * ray.direction, hit.found);
    float clear = exp(-t / fogDistance) * clamp((FAR - t) / FADE, 0.0, 1.0);
    return encodeSRGB(mix(skyLight(ray.direction), light, clear));
}
