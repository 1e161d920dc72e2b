// 15 The picture: the courtyard of chapter 14 as a photograph, early on a misty morning.

#include "main.glsl"      // main(): calls pixelRay, then rayColour
#include "courtyard.glsl" // the scene: courtyardSurfaceFrom, courtyardDistance, troughReached, arcadeCorners
#include "lighting.glsl"  // lambert, encodeSRGB
#include "fog.glsl"       // fogDepth, skyFogDepth, inverseFogDepth, fogLight, throughFog
#include "film.glsl"      // exposed, cosineFourth, contrast, filmCurve, filmOfLargest, ditherStep
#include "lens.glsl"      // lensRay, sampleDisc; includes lampDirection, shadowRay, lightReaching
#include "filter.glsl"    // filteredScreen; includes sampleLine

uniform float fogDensity;   // 0.09 in [0, 1] step 0.01, per scene unit: share of the light that the mist removes at the floor
uniform float fogScale;     // 1.6 in [0.1, 1000] step *1.1, scene units: height at which the mist has thinned to 1 / e
uniform int   shafts;       // 3 in [0, 16]: points per ray at which the mist is tested for sun or shade; 0: it is always in the sun
uniform float sunElevation; // 15 in [3, 60] step 1, degrees: height of the sun above the horizon
uniform float sunAzimuth;   // 66 in [0, 360] step 2, degrees: azimuth of the sun, from the right towards the viewer
uniform float sunSpread;    // 0.012 in [0.001, 0.1] step *1.1: radius of the sun's disc at a distance of one unit
uniform float aperture;     // 0.03 in [0, 0.3] step 0.005, scene units: radius of the lens; with one sample it is a pinhole
uniform float focus;        // 4.5 in [0.5, 40] step *1.05, scene units: distance of the plane in focus
uniform int   kernel;       // 1 in [0, 2]: filter of a pixel: 0 box, 1 tent, 2 Gaussian
uniform bool  jitter;       // true: each sample is at a random point of its cell; false: at the cell's centre
uniform float exposure;     // 0 in [-6, 6] step 0.25, stops: each doubles the light
uniform bool  vignette;     // true: light falls off from the centre as cos^4
uniform int   curve;        // 1 in [0, 2]: 0 clamp, 1 film on each channel, 2 film on the largest channel
uniform float gamma;        // 1.45 in [1, 3] step 0.05: steepness of the film's curve
uniform float white;        // 8 in [1.5, 64] step *1.1: the light that becomes white
uniform float punch;        // 0 in [0, 1] step 0.1: contrast of the encoded values; 1 is a smoothstep
uniform bool  dither;       // true: a fixed pattern before the rounding to 255 steps
uniform int   maxSteps;     // 128 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.001 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

const vec3  SUN_COLOUR = vec3(5.4, 3.2, 1.45);      // light of the sun on a surface that faces it, linear RGB
const vec3  SKY_COLOUR = vec3(0.21, 0.34, 0.58);    // light from above
const vec3  COURT_COLOUR = vec3(0.16, 0.15, 0.16);  // light from below, reflected by the court
const vec3  MIST_SKY = vec3(0.10, 0.16, 0.27);      // light of the sky that the mist scatters
const vec3  MIST_SUN = vec3(3.3, 1.90, 0.86);       // light of the sun that the mist scatters straight ahead
const float FORWARD = 0.6;                          // mean cosine of the scattering angle
const vec3  AIR_LOW = vec3(-4.74, 0.61, -6.19);     // opposite corners of an empty box in the gallery
const vec3  AIR_HIGH = vec3(4.74, 3.70, -4.29);
const float ARCADE = -4.0;                          // z of the middle of the arcade's wall
const float SKY = 1e4;                              // distance to the sky, scene units
const float EAVES = 3.5;                            // height above which the roof blocks the sun

// ---- Lens ----

Ray pixelRay(vec2 screen)
{
    Ray ray = perspectiveRay(filteredScreen(screen, kernel, jitter, 0));
    return lensRay(ray, sampleDisc(2), aperture, focus);
}

// ---- Light ----

float sceneDistance(vec3 p)
{
    return courtyardDistance(p);
}

vec3 sunDirection()
{
    float azimuth = radians(sunAzimuth), elevation = radians(sunElevation);
    return vec3(cos(elevation) * vec2(cos(azimuth), sin(azimuth)), sin(elevation)).xzy;
}

// The sky is gold around the sun and blue above.
vec3 skyLight(vec3 direction, vec3 toSun)
{
    vec3 blue = mix(vec3(0.60, 0.58, 0.62), vec3(0.16, 0.27, 0.48), smoothstep(0.0, 0.55, direction.y));
    return blue + vec3(1.6, 0.95, 0.42) * glow(direction, toSun, 0.7);
}

// 1 if a point of the mist is in the sun, otherwise 0. Only the walls and the arcade are tested,
// because all other objects are too small to matter.
float mistLit(Ray toSun)
{
    float t = (ARCADE - toSun.origin.z) / toSun.direction.z;
    vec3 p = vec3(toSun.origin.xy + t * toSun.direction.xy, ARCADE); // in the middle of the arcade's wall
    bool through = t < 0.0 || (p.y < EAVES && arcadeCorners(p).y > 0.0);
    return through && troughReached(toSun) >= COURT_FAR ? 1.0 : 0.0;
}

// The share of the mist along a ray that is in the sun: the mean of mistLit over points of the ray.
// The points are denser where the mist sends more light to the eye.
//   depth  optical depth of the ray
float mistSeen(Ray ray, float depth, vec3 toSun)
{
    float lit = 0.0, lot = sampleLine(6), lost = 1.0 - exp(-depth);
    for (int i = 0; i < shafts; i++) {
        float reached = -log(1.0 - (float(i) + lot) / float(shafts) * lost);
        float t = inverseFogDepth(ray.origin.y, ray.direction.y, reached, fogDensity, fogScale);
        lit += mistLit(Ray(ray.origin + t * ray.direction, toSun));
    }
    return shafts > 0 ? lit / float(shafts) : 1.0;
}

// The light that a point sends to the eye: the light of the sun and of the sky that it reflects.
vec3 surfaceLight(Surface surface, vec3 toSun)
{
    Ray ray = shadowRay(surface.p, surface.normal, toSun, 2.0 * surface.radius);
    bool free = !surface.open && troughReached(ray) >= COURT_FAR; // true if no side wall hides the sun
    float far = free ? shadowReach(surface.normal, toSun, boxInterval(ray, COURT_LOW, COURT_HIGH).y) : 0.0;
    float seen = free ? lightReaching(ray, far, hitThreshold, maxSteps) : 0.0;
    float outdoors = smoothstep(-6.2, -3.6, surface.p.z); // share of the sky left open by the roof, estimated by eye
    vec3 sky = (0.3 + 0.7 * outdoors) * mix(COURT_COLOUR, SKY_COLOUR, 0.5 + 0.5 * surface.normal.y);
    return surface.colour * (sky + seen * lambert(surface.normal, toSun) * SUN_COLOUR);
}

// The light along a ray: the light from its end, the light from the mist, and how much mist is in
// between.
struct Seen {
    vec3  light; // linear
    vec3  fog;
    float way;   // length of the path, scene units
    float depth; // optical depth of the mist on this path
};

Seen seenAlong(Ray ray)
{
    vec3 toSun = sunDirection(), sunRay = lampDirection(toSun, sunSpread, sampleDisc(4));
    vec2 air = boxInterval(ray, AIR_LOW, AIR_HIGH);
    Surface surface = courtyardSurfaceFrom(ray, air.x > 0.0 ? 0.0 : air.y, hitThreshold, maxSteps);
    float way = surface.open ? SKY : length(surface.p - ray.origin);
    float depth = surface.open ? skyFogDepth(ray.origin.y, ray.direction.y, fogDensity, fogScale)
                             : fogDepth(ray.origin.y, ray.direction.y, way, fogDensity, fogScale);
    vec3 light = surface.open ? skyLight(ray.direction, toSun) : surfaceLight(surface, sunRay);
    vec3 mist = mistSeen(ray, depth, sunRay) * MIST_SUN;
    return Seen(light, fogLight(ray.direction, toSun, MIST_SKY, mist, FORWARD), way, depth);
}

// ---- Film ----

// Convert the light on the film to the displayed light, which is still linear.
vec3 developed(vec3 light)
{
    vec3 film = curve == 2 ? filmOfLargest(light, gamma, white) : filmCurve(light, gamma, white);
    return curve == 0 ? clamp(light, 0.0, 1.0) : film;
}

// The light that the film receives: the light that has passed through the mist, weakened off the
// axis and multiplied by the exposure.
vec3 lightOnFilm(Ray ray)
{
    Seen seen = seenAlong(ray);
    float share = vignette ? cosineFourth(screenPosition(vec2(iPixel) + 0.5), focalLength) : 1.0;
    return exposed(share * throughFog(seen.light, seen.fog, seen.depth), exposure);
}

// The encoded values of the pixel, with more contrast if requested. The dither is added last.
vec3 rayColour(Ray ray)
{
    vec3 numbers = contrast(encodeSRGB(developed(lightOnFilm(ray))), punch);
    return numbers + (dither ? ditherStep(iPixel) / 255.0 : 0.0);
}
