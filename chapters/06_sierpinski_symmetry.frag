// 06 Symmetry: 3 m folds make a pyramid of 4^m tetrahedra, where m is the parameter levels. The
// threshold of the march grows with the footprint of a pixel.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "camera.glsl"     // perspectiveRay
#include "cone.glsl"       // marchCone, pixelSpread, coneReaching
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdBox
#include "symmetry.glsl"   // sdSierpinskiPlanes, sdTetrahedronPlanes, foldToCorner, tetrahedronInterval
#include "hue.glsl"        // hsvToRGB
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach
#include "bounds.glsl"     // boxInterval, intervalUnion

uniform int   levels;       // 7 in [0, 10]: how many times each tetrahedron is divided into four
uniform float footprint;    // 1.5 in [0, 4] step 0.25, half pixels: how fast the threshold and the normal's step grow along the ray; 0 keeps them fixed
uniform float tint;         // 0.5 in [0, 1] step 0.05: saturation of the colours that come from the folds
uniform float sunElevation; // 28 in [1, 89] step 1, degrees: height of the sun above the horizon
uniform float sunAzimuth;   // 160 in [-180, 180] step 5, degrees: azimuth of the sun, from the right towards the viewer
uniform float sunSpeed;     // 8 in [0, 90] step 1, degrees per second: speed of the sun's azimuth
uniform int   maxSteps;     // 160 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0002 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit, at the eye
uniform float normalStep;   // 0.0005 in [0.0000001, 0.5] step *2, scene units: step of the differences that give the normal, at the eye

const float SIZE = 1.1;                            // size of the pyramid, whose height is 4 SIZE / sqrt(3)
const vec3  PYRAMID = vec3(-0.7, 0.63508530, -0.5); // centre of the pyramid, SIZE / sqrt(3) above the ground
const vec3  SLAB = vec3(0.0, -0.1, 0.0);           // centre and half size of the slab under the pyramid
const vec3  SLAB_HALF = vec3(4.2, 0.1, 3.2);
const float MARGIN = 0.02;                         // margin of the bounds around the pyramid and the slab

// The columns are the world's axes in the coordinates of the pyramid, whose corner (1, 1, 1) points
// up. The matrix is a rotation, so distances stay exact, as in chapter 05.
const mat3 TO_PYRAMID = mat3( 0.70710678, -0.70710678, 0.0,
                              0.57735027,  0.57735027, 0.57735027,
                             -0.40824829, -0.40824829, 0.81649658);

const vec3  SUN_COLOUR = vec3(1.22, 0.65, 0.20);    // light of the sun on a surface that faces it
const vec3  SKY_COLOUR = vec3(0.12, 0.20, 0.38);   // light from above, linear RGB
const vec3  EARTH_COLOUR = vec3(0.03, 0.03, 0.04); // light from below
const vec3  SLAB_COLOUR = vec3(0.12, 0.13, 0.16);
const float TILE = 0.5;                            // side of a paving stone, scene units
const float JOINT = 0.008;                         // half the width of a joint
const float SUN_SPREAD = 0.02;                     // tangent of the angular radius of the sun's disc

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

// The interval in which a ray can hit the scene.
vec2 sceneInterval(Ray ray)
{
    vec2 pyramid = pyramidInterval(ray);
    vec2 slab = boxInterval(ray, SLAB - SLAB_HALF - MARGIN, SLAB + SLAB_HALF + MARGIN);
    return intervalUnion(pyramid, slab);
}

// Two values that the first four levels of folds determine for a point.
struct Trail {
    float address; // a binary fraction: the digit of a level is 1 if its folds move the point
    float open;    // at most 1: the deeper the point is in a level's tetrahedron, the more that level reduces open
};

Trail foldTrail(vec3 p)
{
    vec3 q = pyramidPoint(p) - SIZE;
    float size = SIZE, digit = 0.5;
    Trail trail = Trail(0.0, 1.0);
    for (int i = 0; i < 4; i++) {
        trail.open *= 1.0 + min(1.5 * sdTetrahedronPlanes(q + size, size) / size, 0.0);
        vec3 folded = foldToCorner(q, size);
        trail.address += folded == q ? 0.0 : digit;
        q = folded;
        size *= 0.5;
        digit *= 0.5;
    }
    return trail;
}

// The paving: squares with joints that darken a pixel in proportion to the share of its footprint
// that they cover.
//   radius  of the footprint at p, perpendicular to the view; a grazing view stretches it on the
//           ground
vec3 slabColour(vec3 p, vec3 direction, float radius)
{
    vec2 reach = radius * (1.0 + abs(direction.xz / direction.y));
    vec2 away = TILE * (0.5 - abs(fract(p.xz / TILE) - 0.5)); // distances to the nearest joints
    vec2 joint = max((min(away + reach, JOINT) - max(away - reach, -JOINT)) / (2.0 * reach), 0.0);
    return SLAB_COLOUR * (1.0 - 0.5 * max(joint.x, joint.y));
}

// The stone is gold where no fold moves the point and rose where all folds do. A point nearer to the slab than the
// radius of the footprint has the colour of the slab.
vec3 colourAt(vec3 p, vec3 direction, Trail trail, float radius)
{
    vec3 stone = hsvToRGB(46.0 - 60.0 * trail.address, tint, 0.85);
    return slabDistance(p) < radius ? slabColour(p, direction, radius) : stone;
}

vec3 sunDirection()
{
    float azimuth = radians(sunAzimuth + sunSpeed * iTime);
    float elevation = radians(sunElevation);
    return vec3(cos(elevation) * vec2(cos(azimuth), sin(azimuth)), sin(elevation)).xzy;
}

// A range of mountains that rises from the mist in front of what is behind it.
//   around, high    the direction: along the horizon, in quarters of a turn, and the sine of its elevation
//   foot            sine of the elevation up to which the mist hides the rock
//   peaks, heights  peaks of four kinds: how many of them fit into a quarter of a turn, and twice their heights. The
//                   horizon closes without a seam if each number of peaks is a multiple of 1/4.
vec3 mountains(vec3 behind, vec3 rock, vec3 mist, float around, float high, float foot, vec4 peaks, vec4 heights)
{
    float crest = foot + dot(heights, abs(fract(peaks * around + vec4(0.1, 0.4, 0.7, 0.2)) - 0.5));
    vec3 veiled = mix(mist, rock, clamp(9.0 * (high - foot), 0.0, 1.0));
    return mix(behind, veiled, clamp((crest - high) / (1.5 * pixelSpread()), 0.0, 1.0));
}

// The evening sky: blue above, and a warm band above the horizon, which is warmest towards the sun.
// Below it lies a valley full of mist, with two ranges of mountains and, nearer, the tops of a
// forest, which show how large the pyramid is.
vec3 skyLight(vec3 direction, vec3 toSun)
{
    float facing = 0.5 + 0.5 * dot(direction, toSun), high = direction.y;
    float side = direction.x / max(abs(direction.x) + abs(direction.z), 1e-6);
    float around = direction.z < 0.0 ? side : 2.0 - side;
    vec3 band = mix(vec3(0.09, 0.10, 0.20), vec3(1.40, 0.58, 0.16), facing * facing);
    vec3 sky = mix(band, vec3(0.008, 0.024, 0.085), smoothstep(0.0, 0.36, high));
    vec3 mist = mix(vec3(0.10, 0.11, 0.19), vec3(0.80, 0.40, 0.22), facing * facing) * clamp(1.1 + 1.5 * high, 0.3, 1.0);
    sky = mountains(sky, vec3(0.06, 0.07, 0.15), mist, around, high, 0.0,
                    vec4(1.25, 3.0, 7.25, 19.0), vec4(0.16, 0.10, 0.05, 0.015));
    sky = mountains(sky, vec3(0.03, 0.04, 0.09), mist, around, high, -0.06,
                    vec4(1.0, 2.25, 9.5, 31.0), vec4(0.14, 0.08, 0.03, 0.008));
    return mountains(sky, vec3(0.012, 0.018, 0.045), mist, around, high, -0.18,
                     vec4(1.5, 53.0, 97.0, 161.0), vec4(0.17, 0.010, 0.012, 0.012));
}

// The light that arrives from the sun. A ray is marched only where the surface faces the sun, and
// only through the pyramid.
//   radius  of the pixel's footprint at p
vec3 sunLight(vec3 p, vec3 normal, vec3 toSun, float radius)
{
    Ray ray = shadowRay(p, normal, toSun, 2.0 * radius);
    vec2 interval = pyramidInterval(ray);
    float far = shadowReach(normal, toSun, interval.y);
    float seen = coneReaching(ray, interval.x, far, radius, SUN_SPREAD, maxSteps);
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
        float radius = hitThreshold + spread * hit.t;
        vec3 normal = normalAt(p, normalStep + spread * hit.t);
        Trail trail = foldTrail(p);
        vec3 ambient = mix(EARTH_COLOUR, SKY_COLOUR, (0.5 + 0.5 * normal.y) * trail.open);
        light = colourAt(p, ray.direction, trail, radius) * (ambient + sunLight(p, normal, toSun, radius));
    }
    return encodeSRGB(light);
}
