// 06 Symmetry: a pyramid of 4^n tetrahedra out of 3 n folds, and a march with a pixel's footprint.

#include "main.glsl"       // main(): asks for pixelRay, then for rayColour
#include "camera.glsl"     // perspectiveRay
#include "cone.glsl"       // marchCone, pixelSpread, coneReaching
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdBox
#include "symmetry.glsl"   // sdSierpinskiPlanes, foldToCorner, tetrahedronInterval
#include "hue.glsl"        // hsvToRGB
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach
#include "bounds.glsl"     // boxInterval, intervalUnion

uniform int   levels;       // 7 in [0, 10]: how often each tetrahedron is cut in four
uniform float footprint;    // 1.5 in [0, 4] step 0.25, half pixels: how fast the threshold and the normal's step grow along the ray; 0 keeps them fixed
uniform float tint;         // 0.5 in [0, 1] step 0.05: saturation of the colours that the folds give
uniform float sunElevation; // 26 in [1, 89] step 1, degrees: height of the sun over the horizon
uniform float sunAzimuth;   // -170 in [-180, 180] step 5, degrees: where the sun stands, from the right towards the viewer
uniform float sunSpeed;     // 8 in [0, 90] step 1, degrees per second: how fast it goes round
uniform int   maxSteps;     // 160 in [1, 1024]: steps before a ray is given up
uniform float hitThreshold; // 0.0002 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit, at the eye
uniform float normalStep;   // 0.0005 in [0.0000001, 0.5] step *2, scene units: step of the differences that give the normal, at the eye

const float SIZE = 1.1;                            // of the pyramid, whose height is 4 SIZE / sqrt(3)
const vec3  PYRAMID = vec3(-0.7, 0.63508530, -0.5); // its centre, SIZE / sqrt(3) over the ground
const vec3  SLAB = vec3(0.0, -0.1, 0.0);           // centre and half size of the slab it stands on
const vec3  SLAB_HALF = vec3(3.4, 0.1, 2.6);
const float MARGIN = 0.02;                         // by which the bounds of both are larger than they

// The world's axes as the pyramid sees them, in columns: its corner (1, 1, 1) points up. An
// isometry, as in chapter 05.
const mat3 TO_PYRAMID = mat3( 0.70710678, -0.70710678, 0.0,
                              0.57735027,  0.57735027, 0.57735027,
                             -0.40824829, -0.40824829, 0.81649658);

const vec3  SUN_COLOUR = vec3(2.3, 1.2, 0.5);      // its light on a surface that faces it
const vec3  SKY_COLOUR = vec3(0.12, 0.20, 0.38);   // light from above, linear RGB
const vec3  EARTH_COLOUR = vec3(0.03, 0.03, 0.04); // light from below
const vec3  SLAB_COLOUR = vec3(0.40, 0.37, 0.36);
const float SUN_SPREAD = 0.02;                     // tangent of half the angle of the sun's disc

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

vec3 pyramidPoint(vec3 p)
{
    return TO_PYRAMID * (p - PYRAMID);
}

float slabDistance(vec3 p)
{
    return sdBox(p - SLAB, SLAB_HALF);
}

float sceneDistance(vec3 p)
{
    return min(slabDistance(p), sdSierpinskiPlanes(pyramidPoint(p), SIZE, levels));
}

vec2 pyramidInterval(Ray ray)
{
    Ray turned = Ray(pyramidPoint(ray.origin), TO_PYRAMID * ray.direction);
    return tetrahedronInterval(turned, SIZE + 1.7320508 * MARGIN);
}

// The interval of a ray in which there is something to hit.
vec2 sceneInterval(Ray ray)
{
    vec2 pyramid = pyramidInterval(ray);
    vec2 slab = boxInterval(ray, SLAB - SLAB_HALF - MARGIN, SLAB + SLAB_HALF + MARGIN);
    return intervalUnion(pyramid, slab);
}

// What the first four levels of folds say about a point. x: a binary number below 1, of which each
// level that moves the point is a digit; 0 at the top. y: how open the point is, from 1 down; each
// level takes away by the depth in its tetrahedron.
vec2 foldTrail(vec3 p)
{
    vec3 q = pyramidPoint(p) - SIZE;
    float size = SIZE, digit = 0.5;
    vec2 trail = vec2(0.0, 1.0);
    for (int i = 0; i < 4; i++) {
        trail.y *= 1.0 + min(1.5 * sdTetrahedronPlanes(q + size, size) / size, 0.0);
        vec3 folded = foldToCorner(q, size);
        trail.x += folded == q ? 0.0 : digit;
        q = folded;
        size *= 0.5;
        digit *= 0.5;
    }
    return trail;
}

// Gold where no fold moves the point, rose where all do; the slab is plain.
//   size  of the pixel's footprint at p: what is so near to the slab counts as the slab
vec3 colourAt(vec3 p, vec2 trail, float size)
{
    vec3 stone = hsvToRGB(46.0 - 72.0 * trail.x, tint, 0.85);
    return slabDistance(p) < size ? SLAB_COLOUR : stone;
}

vec3 sunDirection()
{
    float azimuth = radians(sunAzimuth + sunSpeed * iTime);
    float elevation = radians(sunElevation);
    return vec3(cos(elevation) * vec2(cos(azimuth), sin(azimuth)), sin(elevation)).xzy;
}

// The evening sky: deep blue above, warm along the horizon where the sun is, haze below.
vec3 skyLight(vec3 direction, vec3 toSun)
{
    float facing = 0.5 + 0.5 * dot(direction, toSun);
    vec3 horizon = mix(vec3(0.16, 0.15, 0.22), vec3(0.95, 0.42, 0.15), facing * facing);
    vec3 sky = mix(horizon, vec3(0.010, 0.032, 0.10), smoothstep(-0.1, 0.45, direction.y));
    return mix(vec3(0.045, 0.06, 0.10), sky, smoothstep(-0.16, 0.04, direction.y));
}

// The sun's light that arrives; looked for only where the surface faces it, and only in the pyramid.
//   size  of the pixel's footprint at p
vec3 sunLight(vec3 p, vec3 normal, vec3 toSun, float size)
{
    Ray ray = shadowRay(p, normal, toSun, 2.0 * size);
    vec2 interval = pyramidInterval(ray);
    float far = shadowReach(normal, toSun, interval.y);
    float seen = coneReaching(ray, interval.x, far, size, SUN_SPREAD, maxSteps);
    return seen * lambert(normal, toSun) * SUN_COLOUR;
}

vec3 rayColour(Ray ray)
{
    vec2 interval = sceneInterval(ray);
    float spread = footprint * pixelSpread();
    Hit hit = marchCone(ray, interval.x, interval.y, hitThreshold, spread, maxSteps);
    vec3 toSun = sunDirection();
    vec3 light = skyLight(ray.direction, toSun);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        float size = hitThreshold + spread * hit.t;
        vec3 normal = normalAt(p, normalStep + spread * hit.t);
        vec2 trail = foldTrail(p);
        vec3 ambient = mix(EARTH_COLOUR, SKY_COLOUR, (0.5 + 0.5 * normal.y) * trail.y);
        light = colourAt(p, trail, size) * (ambient + sunLight(p, normal, toSun, size));
    }
    return encodeSRGB(light);
}
