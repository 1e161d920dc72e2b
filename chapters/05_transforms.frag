// 05 Transformations: things are moved, turned and twisted by asking about another point. A sea, and
// what floats on it.

#include "main.glsl"       // main(): asks for pixelRay, then for rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, lightReaching
#include "bounds.glsl"     // boxInterval
#include "transform.glsl"  // rotations, opTwist, the stretch of each deformation, sdTorus

uniform float waveHeight;   // 1 in [0, 3] step 0.1, times a calm sea: height of the waves
uniform float twist;        // 0.9 in [0, 3] step 0.1, radians per scene unit: twist of the ring along its length
uniform float stepScale;    // 1 in [0.2, 4] step 0.1, times the safe step: more than 1 makes holes
uniform float sunAzimuth;   // -26 in [-180, 180] step 2, degrees: where the sun stands, 0 straight ahead, right positive
uniform int   maxSteps;     // 160 in [1, 512]: steps before a ray is given up
uniform float hitThreshold; // 0.002 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

const vec3  LOW = vec3(-14.0, -0.35, -24.0);  // opposite corners of a box that holds waves and things:
const vec3  HIGH = vec3(14.0, 1.3, 5.5);      // farther away the sea is drawn flat
const vec3  THINGS_LOW = vec3(-2.6, -0.3, -4.6); // and of one that holds the things alone
const vec3  THINGS_HIGH = vec3(3.9, 1.3, 2.6);

// Four waves at once: amplitudes, wave vectors (x and z), and angular speeds sqrt(9.81 |k|).
const vec4  AMPLITUDE = vec4(0.060, 0.035, 0.022, 0.012);
const vec4  WAVE_X = vec4(0.45, -1.10, 1.90, -2.1);
const vec4  WAVE_Z = vec4(1.20, 1.70, 1.60, 3.9);
const vec4  WAVE_SPEED = vec4(3.55, 4.46, 4.94, 6.59);

// The place and the rotation of each thing that floats: found once a pixel, by setAfloat.
struct Pose {
    vec3 place;
    mat3 turn;
};
Pose ringPose, ballPose, cratePose;

// The phases of the four waves over a point of the sea.
vec4 wavePhase(vec2 xz)
{
    return WAVE_X * xz.x + WAVE_Z * xz.y + WAVE_SPEED * iTime;
}

float seaHeight(vec2 xz)
{
    return waveHeight * dot(AMPLITUDE, sin(wavePhase(xz)));
}

vec2 seaSlope(vec2 xz)
{
    vec4 change = waveHeight * AMPLITUDE * cos(wavePhase(xz));
    return vec2(dot(WAVE_X, change), dot(WAVE_Z, change));
}

// Afloat: up and down with the sea at a place, its deck along the water there.
//   draught  how high the middle floats
//   turn     how the thing lies in still water
Pose afloat(vec2 xz, float draught, mat3 turn)
{
    vec2 slope = seaSlope(xz);
    mat3 rock = rotationX(slope.y) * rotationZ(-slope.x);
    return Pose(vec3(xz.x, seaHeight(xz) + draught, xz.y), transpose(rock) * turn);
}

void setAfloat()
{
    ringPose = afloat(vec2(-1.2, 1.2), 0.16, rotationY(0.5) * rotationZ(0.22) * rotationX(-1.35));
    ballPose = afloat(vec2(0.95, -1.3), 0.18, rotationY(0.4) * rotationZ(-0.35));
    cratePose = afloat(vec2(3.0, -2.8), 0.12, rotationY(0.7) * rotationX(0.5) * rotationZ(0.3));
}

Ray pixelRay(vec2 screen)
{
    setAfloat();
    return perspectiveRay(screen);
}

// A point, seen from a thing: moved back, then turned back. A row times a matrix is the transposed
// matrix times the column: the inverse rotation.
vec3 seenFrom(Pose pose, vec3 p)
{
    return (p - pose.place) * pose.turn;
}

const float RING_REACH = 0.95; // radius of a ball around the ring, of a cylinder around its axis

vec3 ringPoint(vec3 p)
{
    return opTwist(seenFrom(ringPose, p), twist);
}

float ringDistance(vec3 p)
{
    vec3 q = seenFrom(ringPose, p);
    float around = length(q) - RING_REACH;
    float ring = sdTorus(opTwist(q, twist).xzy, 0.66, 0.17) / twistStretch(twist, RING_REACH + 0.1);
    return around > 0.1 ? around : ring;
}

float thingsDistance(vec3 p)
{
    float ball = sdSphere(seenFrom(ballPose, p), 0.62);
    float crate = sdBox(seenFrom(cratePose, p), vec3(0.42)) - 0.02;
    return min(ringDistance(p), min(ball, crate));
}

float seaDistance(vec3 p)
{
    return (p.y - seaHeight(p.xz)) / heightStretch(waveHeight * 0.28);
}

float sceneDistance(vec3 p)
{
    return stepScale * min(seaDistance(p), thingsDistance(p));
}

vec3 toSun()
{
    float azimuth = radians(sunAzimuth);
    return normalize(vec3(sin(azimuth), 0.21, -cos(azimuth)));
}

// The sky in a direction: blue above, golden along the horizon towards the sun.
vec3 skyLight(vec3 direction)
{
    float height = max(direction.y, 0.0);
    float towards = max(dot(direction, toSun()), 0.0);
    vec3 blue = mix(vec3(0.34, 0.44, 0.55), vec3(0.05, 0.16, 0.38), 1.0 - exp(-4.0 * height));
    float low = exp(-7.0 * height);
    float t2 = towards * towards, t4 = t2 * t2;
    vec3 glow = vec3(1.0, 0.52, 0.20) * (0.55 * t4 * low) + vec3(1.0, 0.75, 0.45) * 0.5 * pow(towards, 40.0);
    return blue + glow * 1.0;
}

vec3 sunLight(vec3 direction)
{
    return vec3(9.0, 7.0, 4.0) * smoothstep(0.9990, 0.9994, dot(direction, toSun()));
}

// The colour of a thing's surface at p.
vec3 colourAt(vec3 p)
{
    vec3 ring = ringPoint(p), ball = seenFrom(ballPose, p), crate = seenFrom(cratePose, p);
    float square = 2.0 * ring.x * ring.x / dot(ring.xy, ring.xy) - 1.0;
    float band = smoothstep(-0.04, 0.04, 2.0 * square * square - 1.0 - 0.45);
    vec3 colour = mix(vec3(0.75, 0.025, 0.015), vec3(0.85, 0.82, 0.75), band);
    float stripe = smoothstep(0.0, 0.01, abs(ball.y - 0.1) - 0.07);
    if (sdSphere(ball, 0.62) < 0.02)
        colour = mix(vec3(0.05, 0.05, 0.06), vec3(0.95, 0.55, 0.02), stripe);
    vec3 edge = smoothstep(0.30, 0.31, abs(crate));
    if (sdBox(crate, vec3(0.42)) < 0.04)
        colour = mix(vec3(0.36, 0.17, 0.06), vec3(0.16, 0.07, 0.025), 0.0);
    return colour;
}

vec3 thingLight(vec3 p, vec3 normal, vec3 view)
{
    Ray ray = shadowRay(p, normal, toSun(), 4.0 * hitThreshold);
    float seen = lightReaching(ray, boxInterval(ray, THINGS_LOW, THINGS_HIGH).y, hitThreshold, maxSteps);
    vec3 light = vec3(2.6, 1.75, 0.95) * lambert(normal, toSun()) * seen;
    vec3 ambient = mix(vec3(0.10, 0.13, 0.15), vec3(0.30, 0.38, 0.50), 0.5 + 0.5 * normal.y);
    return colourAt(p) * (light + ambient);
}

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    float level = ray.direction.y < -0.0001 ? -ray.origin.y / ray.direction.y : 10000.0;
    float t = hit.found ? hit.t : level;
    vec3 p = ray.origin + t * ray.direction;
    bool thing = hit.found && thingsDistance(p) < seaDistance(p);
    vec3 sky = skyLight(ray.direction) + sunLight(ray.direction);

    // water
    float fade = 1.0 / (1.0 + 0.006 * t * t);
    vec3 normal = normalAt(p, 0.002);
    vec4 ripple = cos(vec4(5.1, -6.3, 9.7, 3.3) * p.x + vec4(4.3, 7.7, 5.9, -12.1) * p.z + vec4(6.8, 9.9, 10.6, 11.1) * iTime + 1.5 * sin(vec4(1.3, 2.1, -1.7, 0.9) * p.x + vec4(-1.9, 1.1, 2.3, 2.7) * p.z));
    vec2 slope = 0.035 * vec2(dot(vec4(0.7, -0.6, 0.8, 0.2), ripple), dot(vec4(0.6, 0.7, 0.5, -0.9), ripple));
    vec3 n = normalize(vec3(fade * (seaSlope(p.xz) + slope), 1.0).xzy * vec3(-1.0, 1.0, -1.0));
    vec3 mirrored = reflect(ray.direction, n);
    mirrored.y = abs(mirrored.y);
    float c = 1.0 - max(dot(n, -ray.direction), 0.0);
    float fresnel = 0.02 + 0.98 * c * c * c * c * c;
    vec3 glint = vec3(9.0, 6.5, 3.5) * 0.6 * pow(max(dot(mirrored, toSun()), 0.0), 260.0);
    vec3 body = vec3(0.006, 0.045, 0.065) + vec3(0.0, 0.05, 0.05) * max(p.y / 0.13, 0.0);
    vec3 water = mix(body, skyLight(mirrored), fresnel) + glint;
    vec3 haze = skyLight(vec3(ray.direction.x, 0.0, ray.direction.z));
    water = mix(haze, water, exp(-0.012 * t));

    vec3 light = thing ? thingLight(p, normal, ray.direction) : (t < 9999.0 ? water : sky);
    return encodeSRGB(light);
}
