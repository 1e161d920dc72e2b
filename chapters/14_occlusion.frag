// 14 Occlusion: an overcast day. The whole sky is the lamp, and only a share of it is visible from
// a point.

#include "main.glsl"        // main(): calls pixelRay, then rayColour
#include "cone.glsl"        // perspectiveRay
#include "lighting.glsl"    // encodeSRGB
#include "occlusion.glsl"   // openOverGround, openByTaps, skyReaching, skyAndBounces
#include "courtyard.glsl"   // the court: courtyardSurface, courtyardDistance, troughDistance

uniform int   method;       // 1 in [0, 3]: 0 nothing hides the sky, 1 five taps, 2 many rays, 3 the error, taps minus rays: blue is too dark
uniform float reach;        // 5 in [0.1, 10] step *1.2, scene units: height of the last tap
uniform float strength;     // 1 in [0, 2] step 0.05: how much a tap darkens
uniform int   rays;         // 4 in [1, 8]: rays per side: with methods 2 and 3 each sample sends rays x rays
uniform int   bounces;      // 2 in [0, 2]: light reflected by nearby surfaces: 0 never, 1 once, 2 any number of times
uniform bool  bare;         // false: show the openness itself, without colours
uniform int   maxSteps;     // 128 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

const vec3 SKY = vec3(1.18, 1.22, 1.26);              // light of the whole sky on an open floor, linear RGB
const vec3 NEAR = vec3(0.66, 0.56, 0.46);             // share of light that the court's surfaces reflect, on average
const vec3 DARKER = vec3(0.03, 0.16, 0.50), LIGHTER = vec3(0.85, 0.32, 0.02); // colours of large errors of the taps

bool lookingRound; // true for taps and rays to the sky, false for the ray from the eye

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// A division finds where the ray from the eye meets the floor and the side walls, so these are part
// of the distance only for the taps and for rays to the sky.
float sceneDistance(vec3 p)
{
    float trough = lookingRound ? troughDistance(p) : COURT_FAR;
    return min(courtyardDistance(p), trough);
}

// An overcast sky, nearly three times as bright at the zenith as at the horizon. Only the eye sees the folds of the
// clouds; the light of the court is that of a uniform sky.
vec3 skyLight(vec3 direction)
{
    float up = max(direction.y, 0.0);
    float fold = octaveNoise(vec3(2.0, 2.0, 3.5) * direction / (0.2 + up), 3, 0.5, 2.0).x;
    return (0.8 + 0.4 * fold) * mix(vec3(0.70, 0.73, 0.76), vec3(0.80, 0.85, 0.90), up) * (0.62 + 0.9 * up);
}

// The openness of a point (see occlusion.glsl), estimated from five taps.
float openQuickly(Surface surface)
{
    return openOverGround(surface.normal) * openByTaps(surface.p, surface.normal, reach, strength);
}

// The openness, measured with many rays.
float openTruly(Surface surface, int side)
{
    return skyReaching(surface.p, surface.normal, 2.0 * surface.radius, COURT_FAR, side, hitThreshold, maxSteps, 0);
}

// The openness, found with the selected method.
float openBy(Surface surface, float taps, float truth)
{
    return method == 0 ? openOverGround(surface.normal) : (method == 1 ? taps : truth);
}

// The light that reaches the eye from a point with a given openness.
vec3 surfaceLight(Surface surface, float open)
{
    vec3 light = SKY * skyAndBounces(open, NEAR, bounces);
    return bare ? vec3(open) : surface.colour * light;
}

// The court in grey, coloured where the taps are wrong.
vec3 errorColour(Surface surface, float off)
{
    vec3 ground = vec3(0.45 + 0.45 * dot(surface.colour, vec3(0.3)));
    return mix(ground, off < 0.0 ? DARKER : LIGHTER, min(2.0 * abs(off), 1.0));
}

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface surface = courtyardSurface(ray, hitThreshold, maxSteps);
    lookingRound = true;
    float taps = openQuickly(surface);
    float truth = openTruly(surface, method >= 2 && !surface.open ? rays : 0);
    lookingRound = false;
    vec3 light = method == 3 ? errorColour(surface, taps - truth) : surfaceLight(surface, openBy(surface, taps, truth));
    return encodeSRGB(surface.open ? skyLight(ray.direction) : light);
}
