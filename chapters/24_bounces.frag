// 24 Light that bounces: one path of light for each pixel and frame, and the mean over all frames.

#include "main.glsl"        // main(): calls pixelRay, frameKept and rayColour
#include "camera.glsl"      // perspectiveRay
#include "window_room.glsl" // the room: roomSurface, reaching
#include "lighting.glsl"    // lambert, encodeSRGB
#include "occlusion.glsl"   // cosineDirection; lampDirection, discPoint, PI of soft_shadow.glsl
#include "sobol.glsl"       // pixelPair; pixelRandom, hashOf of random.glsl
#include "film.glsl"        // exposed, filmCurve

uniform sampler2D history; // the last frame

uniform int   bounces;      // 8 in [0, 64]: how often a path may bounce
uniform int   lights;       // 2 in [0, 2]: the window is found 0 by paths that leave through it, 1 with rays to points of it, 2 in both ways, weighted
uniform int   sequence;     // 2 in [0, 2]: random numbers 0 from a hash, 1 from one good pair for everything, 2 from scrambled Sobol pairs
uniform bool  roulette;     // true: end most of the paths that carry little light
uniform float clampAt;      // 0 in [0, 100] step 1: largest light that a path may bring; 0 for any
uniform int   filterPasses; // 0 in [0, 5]: passes of the filter over the light that has bounced; 0 for no filter
uniform int   gather;       // 16 in [1, 4096]: number of frames before the passes of the filter
uniform float exposure;     // 1 in [-4, 4] step 0.1, stops: exposure
uniform int   seed;         // 0 in [0, 1000]: selects other random numbers
uniform int   maxSteps;     // 256 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0015 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit

const vec3  SUN = vec3(4.6, 3.7, 2.7);             // light of the sun on a surface that faces it, linear RGB
const vec3  TO_SUN = vec3(-0.8177, 0.4088, 0.4055);
const float SUN_RADIUS = 0.012;                    // of the sun's disc, at a distance of one unit
const float WINDOW_AREA = 4.0 * WINDOW.y * WINDOW.z;
const float SAME_PLANE = 0.01;                     // off by so much, a point counts 1/e in the filter, scene units
const int   PAIRS = 512;                           // pairs of random numbers reserved for a seed

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// What is outside: the sky, and a garden below the horizon.
vec3 skyLight(vec3 direction)
{
    vec3 sky = mix(vec3(3.3, 3.6, 3.9), vec3(1.3, 2.1, 3.4), clamp(direction.y, 0.0, 1.0));
    return mix(vec3(0.9, 1.1, 0.45), sky, smoothstep(-0.05, 0.0, direction.y));
}

// ---- Chance ----

// Two random numbers for this frame's path.
//   pair  index of the two numbers within the path
vec2 chance(int pair)
{
    pair += PAIRS * seed;
    if (sequence == 0)
        return vec2(pixelRandom(2 * pair), pixelRandom(2 * pair + 1));
    if (sequence == 2)
        return pixelPair(iSample, pair);
    uvec2 shift = hashOf(uvec4(uvec2(iPixel), uint(pair), 1u)).xy; // step: 1 / g and 1 / g^2, g^3 = g + 1
    return vec2((shift + uint(iSample) * uvec2(3242174889u, 2447445414u)) >> 8u) / 16777216.0;
}

// ---- One path ----

// The light that a surface receives from the sun, through one point of the sun's disc.
vec3 sunLight(Surface s, vec2 square)
{
    vec3 toSun = lampDirection(TO_SUN, SUN_RADIUS, discPoint(square));
    float facing = lambert(s.normal, toSun), far = facing > 0.0 ? (OUTSIDE - s.p.x) / toSun.x : 0.0;
    return facing * SUN * reaching(s.p, s.normal, toSun, far, hitThreshold, maxSteps);
}

// How densely directions from a point reach the window, per unit of solid angle, if points of the window are chosen
// evenly.
//   far  distance to the window along the direction
float windowDensity(vec3 direction, float far)
{
    return far * far / (WINDOW_AREA * max(-direction.x, 1e-6));
}

// The light that a surface receives from the window, through one point of the window.
//   weighted  whether a ray that leaves the surface at random adds the rest
vec3 windowLight(Surface s, vec2 square, bool weighted)
{
    vec3 to = vec3(OUTSIDE, WINDOW_AT.yz + (2.0 * square - 1.0) * WINDOW.yz) - s.p;
    float far = length(to);
    vec3 direction = to / far;
    float facing = lambert(s.normal, direction) / PI, density = windowDensity(direction, far);
    far = facing > 0.0 && direction.x < 0.0 ? far : 0.0;
    float share = facing / (weighted ? density + facing : density);
    return share * skyLight(direction) * reaching(s.p, s.normal, direction, far, hitThreshold, maxSteps);
}

// The light that one path brings to the eye.
//   bounced  true for the light that the first surface receives from other surfaces, before it reflects it
//   away     set to the distance of the first surface; -1 for the window
vec3 pathLight(Ray ray, bool bounced, out float away)
{
    vec3 light = vec3(0.0), carried = vec3(1.0);
    float density = 0.0;
    away = -1.0;
    for (int k = 0; k <= bounces + 1; k++) { // after the last bounce, a path may still leave through the window
        Surface s = roomSurface(ray, hitThreshold, maxSteps);
        bool first = k == 0, counts = !bounced || k > 1 || (k == 1 && !s.open);
        if (s.open) {
            float far = (OUTSIDE - ray.origin.x) / ray.direction.x;
            float both = density / (density + windowDensity(ray.direction, far));
            float weight = first || lights == 0 ? 1.0 : (lights == 1 ? 0.0 : both);
            light += counts ? weight * carried * skyLight(ray.direction) : vec3(0.0);
            break;
        }
        if (k > bounces)
            break;
        away = first ? s.t : away;
        carried *= bounced && first ? vec3(1.0) : s.colour;
        vec3 direct = sunLight(s, chance(4 * k + 1));
        if (lights > 0)
            direct += windowLight(s, chance(4 * k + 2), lights == 2);
        light += counts ? carried * direct : vec3(0.0);
        if (roulette && !first) {
            float stay = min(1.5 * max(carried.r, max(carried.g, carried.b)), 1.0);
            if (chance(4 * k + 4).x >= stay)
                break;
            carried /= stay;
        }
        ray = Ray(s.p + 3.0 * hitThreshold * s.normal, cosineDirection(s.normal, chance(4 * k + 3)));
        density = lambert(s.normal, ray.direction) / PI;
    }
    float largest = max(light.r, max(light.g, light.b));
    return clampAt > 0.0 && largest > clampAt ? clampAt / largest * light : light;
}

// ---- The filter ----

// The mean of what 5 x 5 pixels around this one have kept. A pixel counts as far as its point lies in the plane
// through the surface.
//   apart  distance between these pixels, in pixels
vec3 filtered(Surface s, int apart)
{
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 25; i++) {
        ivec2 off = ivec2(i % 5, i / 5) - 2, there = iPixel + apart * off;
        vec4 kept = texelFetch(history, clamp(there, ivec2(0), ivec2(iResolution.xy) - 1), 0);
        vec3 p = iCameraPosition + kept.a * pixelRay(screenPosition(vec2(there) + 0.5)).direction;
        float share = exp(-abs(dot(p - s.p, s.normal)) / SAME_PLANE) + 1e-4;
        vec2 near = vec2(3 - abs(off)) * vec2(4 - abs(off)) * 0.5; // 6, 3, 1
        sum += kept.a > 0.0 ? share * near.x * near.y * vec4(kept.rgb, 1.0) : vec4(0.0);
    }
    return sum.rgb / max(sum.a, 1e-6);
}

// ---- Frames and picture ----

// Without the filter, the mean light of all frames; with it, the mean light that the first surface receives from other
// surfaces. The fourth number is the distance of this surface.
vec4 frameKept(vec2 pixel)
{
    vec4 last = texelFetch(history, iPixel, 0);
    bool filtering = filterPasses > 0;
    Ray ray = pixelRay(screenPosition(pixel + (filtering ? vec2(0.0) : chance(0) - 0.5)));
    if (filtering && iFrame >= gather) {
        Surface s = roomSurface(ray, hitThreshold, maxSteps);
        return iFrame < gather + filterPasses ? vec4(filtered(s, 1 << (iFrame - gather)), last.a) : last;
    }
    float away;
    vec3 light = pathLight(ray, filtering, away);
    return vec4(mix(last.rgb, light, 1.0 / float(iFrame + 1)), away);
}

vec3 rayColour(Ray ray)
{
    Surface s = roomSurface(ray, hitThreshold, maxSteps);
    vec3 light = texelFetch(history, iPixel, 0).rgb;
    if (filterPasses > 0) {
        vec3 direct = vec3(0.0);
        for (int i = 0; i < 16; i++)
            direct += sunLight(s, pixelPair(16 * iSample + i, 0)) + windowLight(s, pixelPair(16 * iSample + i, 1), false);
        light = s.open ? skyLight(ray.direction) : s.colour * (direct / 16.0 + filtered(s, 1));
    }
    return encodeSRGB(filmCurve(exposed(light, exposure), 1.25, 9.0));
}
