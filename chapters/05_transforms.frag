// 05 Transformations: objects are moved, turned and twisted by evaluating their distances at
// another point. The scene is a sea with floating objects.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay
#include "bounds.glsl"     // boxInterval, intervalUnion
#include "fresnel.glsl"    // schlickShare
#include "transform.glsl"  // rotations, Pose, seenFrom, opTwist, the stretch of each deformation, sdTorus

uniform float waveHeight;   // 1 in [0, 3] step 0.1, times a calm sea: height of the waves
uniform float twist;        // 0.6 in [0, 3] step 0.1, radians per radius of the ring: twist of the ring along its length
uniform float stepScale;    // 1 in [0.2, 4] step 0.1, times the safe step: more than 1 makes holes
uniform float sunAzimuth;   // -25 in [-180, 180] step 2, degrees: azimuth of the sun, 0 straight ahead, positive to the right
uniform int   maxSteps;     // 256 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.004 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

const float FAR = 1000.0; // distance to the sky

// Opposite corners of a box around the waves at waveHeight 1. Outside the box, rays meet the plane
// y = 0 instead of the waves.
const vec3  LOW = vec3(-14.0, -0.125, -10.0);
const vec3  HIGH = vec3(14.0, 0.125, 5.5);

// The three waves: amplitudes, wave vectors (x and z), and angular speeds sqrt(9.81 |k|).
const vec3  AMPLITUDE = vec3(0.060, 0.036, 0.024);
const vec3  WAVE_X = vec3(0.45, -1.10, 1.90);
const vec3  WAVE_Z = vec3(1.20, 1.70, 1.60);
const vec3  WAVE_SPEED = vec3(3.55, 4.46, 4.94);
const float STEEPEST = 0.210;                     // bound of the slope at waveHeight 1: sum of amplitude times |k|
const float RING = 0.66;                          // radius of the ring, scene units
const float RING_REACH = 1.5;                     // radius of the ball in which the ring is evaluated, in ring radii

const vec3  SUN_COLOUR = vec3(2.6, 1.6, 0.7);    // linear RGB

// ---- The sea ----

// The phases of the waves at a point of the sea.
vec3 wavePhase(vec2 xz)
{
    return WAVE_X * xz.x + WAVE_Z * xz.y + WAVE_SPEED * iTime;
}

float seaHeight(vec2 xz)
{
    return waveHeight * dot(AMPLITUDE, sin(wavePhase(xz)));
}

vec2 seaSlope(vec2 xz)
{
    vec3 change = waveHeight * AMPLITUDE * cos(wavePhase(xz));
    return vec2(dot(WAVE_X, change), dot(WAVE_Z, change));
}

// ---- The floating objects and their poses ----

// The pose of an object that moves up and down with the sea and tilts with the water below it.
//   xz       horizontal position of the object
//   height   of the object's centre above the water
//   turn     rotation of the object in still water
Pose afloat(vec2 xz, float height, mat3 turn)
{
    vec2 slope = seaSlope(xz);
    mat3 rock = rotationZ(slope.x) * rotationX(-slope.y);
    return Pose(vec3(xz.x, seaHeight(xz) + height, xz.y), rock * turn);
}

// The state of the scene at the time of the picture: the poses of the objects, and the stretches by
// which distances that are not exact are divided.
struct Moment {
    Pose  ring, ball, crate;
    float ringStretch, seaStretch;
};

Moment momentNow()
{
    return Moment(afloat(vec2(-1.2, 1.2), 0.16, rotationY(0.5) * rotationZ(0.22) * rotationX(-1.35)),
                  afloat(vec2(0.95, -1.3), 0.18, rotationY(0.4) * rotationZ(-0.35)),
                  afloat(vec2(3.0, -2.8), 0.12, rotationY(0.7) * rotationX(0.5) * rotationZ(0.3)),
                  twistStretch(twist, RING_REACH), heightStretch(waveHeight * STEEPEST));
}

// The moment is the same for all points along the rays of a pixel. So pixelRay, which runs first,
// computes it once for everything that follows.
Moment now;

Ray pixelRay(vec2 screen)
{
    now = momentNow();
    return perspectiveRay(screen);
}

// ---- The scene at that moment ----

// The ring is a torus, twisted along y and scaled by RING. The stretch of the twist is bounded only
// near the axis, so farther away the distance to a ball around the ring is used instead.
float ringDistance(vec3 p)
{
    vec3 q = seenFrom(now.ring, p) / RING;
    float ball = length(q) - (RING_REACH - 0.2);
    float ring = sdTorus(opTwist(q, twist).xzy, 1.0, 0.26) / now.ringStretch;
    return RING * (ball > 0.2 ? ball : ring);
}

// A rotation does not change the distance to the ball, so only the ball's position is needed.
float thingsDistance(vec3 p)
{
    float ball = sdSphere(p - now.ball.position, 0.62);
    float crate = sdBox(seenFrom(now.crate, p), vec3(0.42)) - 0.02;
    return min(ringDistance(p), min(ball, crate));
}

float seaDistance(vec3 p)
{
    return (p.y - seaHeight(p.xz)) / now.seaStretch;
}

float sceneDistance(vec3 p)
{
    return stepScale * min(seaDistance(p), thingsDistance(p));
}

// The camera stays above the waves and outside the objects.
float cameraRoom(vec3 p)
{
    return min(seaDistance(p), thingsDistance(p)) - 0.15;
}

// The interval in which a ray is inside a cube that encloses an object.
vec2 cubeInterval(Ray ray, vec3 middle, float reach)
{
    return boxInterval(ray, middle - reach, middle + reach);
}

// The interval in which a ray can meet an object.
vec2 thingsInterval(Ray ray)
{
    vec2 ring = cubeInterval(ray, now.ring.position, RING * (RING_REACH - 0.2));
    vec2 ball = cubeInterval(ray, now.ball.position, 0.65);
    return intervalUnion(intervalUnion(ring, ball), cubeInterval(ray, now.crate.position, 0.77));
}

// The paint of an object at p. It is evaluated at the same point as the distance, so the stripes
// turn with the object.
vec3 colourAt(vec3 p)
{
    vec3 ring = opTwist(seenFrom(now.ring, p) / RING, twist);
    vec3 ball = seenFrom(now.ball, p), crate = seenFrom(now.crate, p);
    float cosine2 = ring.x * ring.x / dot(ring.xy, ring.xy); // squared cosine of the angle around the ring
    vec3 red = mix(vec3(0.75, 0.02, 0.01), vec3(0.8), smoothstep(0.34, 0.36, abs(cosine2 - 0.5)));
    vec3 yellow = mix(vec3(0.03), vec3(0.95, 0.55, 0.02), smoothstep(0.06, 0.07, abs(ball.y - 0.1)));
    vec3 rim = smoothstep(0.34, 0.35, abs(crate)); // 1 for each axis whose face is near; near an edge, two are 1
    vec3 wood = mix(vec3(0.30, 0.14, 0.05), vec3(0.42, 0.24, 0.10), step(1.5, rim.x + rim.y + rim.z));
    vec3 colour = dot(ball, ball) < 0.42 ? yellow : red;
    return dot(crate, crate) < 0.7 ? wood : colour;
}

// ---- Light ----

vec3 sunDirection()
{
    return normalize(rotationY(-radians(sunAzimuth)) * vec3(0.0, 0.18, -1.0));
}

// The light of the sky from a direction: blue above, pale at the horizon, golden towards the sun.
vec3 skyLight(vec3 direction, vec3 toSun)
{
    float low = 1.0 / (1.0 + 5.0 * max(direction.y, 0.0));
    float sun = max(dot(direction, toSun), 0.0);
    float sun4 = sun * sun * sun * sun, sun8 = sun4 * sun4, sun32 = sun8 * sun8 * sun8 * sun8;
    vec3 blue = mix(vec3(0.035, 0.13, 0.36), vec3(0.38, 0.42, 0.50), low * low);
    return blue + vec3(0.62, 0.25, 0.04) * sun8 * low * low + vec3(0.55, 0.36, 0.14) * sun32;
}

// The light of the sun from a direction: a disc in the sky, or a wider spot in a reflection, because
// no surface here is perfectly smooth.
vec3 sunGlare(vec3 direction, vec3 toSun, bool mirrored)
{
    float sun = max(dot(direction, toSun), 0.0);
    return (mirrored ? 12.0 * pow(sun, 260.0) : 4.0 * smoothstep(0.9997, 0.9998, sun)) * SUN_COLOUR;
}

// The light that a matt surface receives.
vec3 receivedLight(vec3 normal, vec3 toSun, bool shadowed)
{
    vec3 sunny = shadowed ? vec3(0.0) : SUN_COLOUR * lambert(normal, toSun);
    return sunny + mix(vec3(0.05, 0.08, 0.10), vec3(0.30, 0.36, 0.46), 0.5 + 0.5 * normal.y);
}

// The light from below the surface of the water: greener in the crests, where the water is thin.
vec3 deepLight(float height)
{
    return vec3(0.004, 0.040, 0.060) + vec3(0.0, 0.07, 0.06) * max(height / 0.12, 0.0);
}

// The normal of the sea, tilted by the waves that the march finds and by ripples that the march
// leaves out. Waves and ripples become flatter as the distance t grows, because waves smaller than a
// pixel would sparkle.
vec3 waterNormal(vec2 xz, float t)
{
    vec4 bent = 1.5 * sin(vec4(1.3, 2.1, -1.7, 0.9) * xz.x + vec4(-1.9, 1.1, 2.3, 2.7) * xz.y);
    vec4 ripple = 0.03 * cos(vec4(5.1, -6.3, 9.7, 3.3) * xz.x + vec4(4.3, 7.7, 5.9, -12.1) * xz.y +
                             vec4(6.8, 9.9, 10.6, 11.1) * iTime + bent);
    vec2 small = vec2(dot(vec4(0.7, -0.6, 0.8, 0.2), ripple), dot(vec4(0.6, 0.7, 0.5, -0.9), ripple));
    vec2 slope = (seaSlope(xz) + small) / (1.0 + 0.006 * t * t);
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

// The share of the water that foam covers at a distance d from the nearest object. The foam is closed
// at the object, and farther away torn into threads, along which a sum of waves is about 0.
float foamShare(vec2 xz, float d)
{
    vec2 bent = xz + 0.03 * sin(15.0 * xz.yx + vec2(0.7, 0.4) * iTime);
    vec4 wave = sin(vec4(41.0, -57.0, 93.0, 11.0) * bent.x + vec4(53.0, 39.0, -71.0, 127.0) * bent.y);
    float thread = abs(dot(wave, vec4(0.4, 0.4, 0.3, 0.3)));
    float near = max(1.0 - d / (0.10 + 0.05 * sin(7.0 * xz.x - 9.0 * xz.y)), 0.0);
    return (1.0 - 0.8 * smoothstep(0.5 * near - 0.1, 0.7 * near + 0.1, thread)) * smoothstep(0.0, 0.8, near);
}

// ---- The picture ----

// True for a hit on an object, which is any hit that is not on the sea.
bool atThing(Hit hit, vec3 p)
{
    return hit.found && stepScale * seaDistance(p) >= hitThreshold;
}

vec3 rayColour(Ray ray)
{
    // The first ray meets an object, the waves, the flat sea beyond them, or the sky.
    vec3 size = vec3(1.0, waveHeight, 1.0), toSun = sunDirection();
    vec2 interval = intervalUnion(thingsInterval(ray), boxInterval(ray, size * LOW, size * HIGH));
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    float flatSea = ray.direction.y < -0.0001 ? -ray.origin.y / ray.direction.y : FAR;
    float t = min(hit.found ? hit.t : flatSea, FAR);
    vec3 p = ray.origin + t * ray.direction;
    bool sky = t >= FAR, thing = atThing(hit, p);
    vec3 normal = hit.found ? normalAt(p, 0.002) : vec3(0.0, 1.0, 0.0);
    normal = thing ? normal : waterNormal(p.xz, t);

    // Foam is as matt as an object, and both are wet at the waterline.
    float gap = thingsDistance(p), foam = foamShare(p.xz, gap);
    bool matt = thing || foam > 0.5;

    // The second ray goes from a matt surface to the sun, or from the water in the mirrored direction.
    vec3 mirrored = sky ? ray.direction : reflect(ray.direction, normal);
    mirrored.y = abs(mirrored.y);
    Ray next = shadowRay(p, normal, matt ? toSun : mirrored, 0.03);
    interval = thingsInterval(next);
    Hit second = march(next, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 q = next.origin + second.t * next.direction;

    // The mirrored image at this point, its share of the light, and the light of the object or the
    // water.
    vec3 image = skyLight(mirrored, toSun) + sunGlare(mirrored, toSun, !sky);
    float share = schlickShare(max(dot(normal, -ray.direction), 0.0), 0.02);
    vec3 paint = colourAt(thing ? p : q);
    paint *= thing ? mix(0.4, 1.0, smoothstep(0.01, 0.05, seaDistance(p))) : 1.0;
    vec3 received = receivedLight(normal, toSun, second.found);
    vec3 ofThing = paint * received + 0.6 * share * image;
    vec3 ofWater = mix(deepLight(p.y), atThing(second, q) && !matt ? 0.6 * paint : image, share);
    ofWater = mix(ofWater * smoothstep(-0.1, 0.2, gap), 0.8 * received, foam);
    vec3 haze = skyLight(vec3(ray.direction.x, 0.0, ray.direction.z), toSun);
    ofWater = mix(haze, ofWater, exp(-0.012 * t));
    return encodeSRGB(sky ? image : (thing ? ofThing : ofWater));
}
