// Solution to exercise 24.3: a furnace. Everything reflects the share `white` and glows with the rest, and the light
// from beyond the window is 1, so all light in the room is 1.
#include "main.glsl"
#define pathLight chapterPathLight
#define frameKept chapterFrameKept
#define rayColour chapterRayColour
#include "24_bounces.frag"
#undef pathLight
#undef frameKept
#undef rayColour

uniform float white; // 0.7 in [0, 1] step 0.05: share of the light that everything reflects

// windowLight with a light of 1 beyond the window.
vec3 windowOfOne(Surface s, vec2 square, bool weighted)
{
    vec3 to = vec3(OUTSIDE, WINDOW_AT.yz + (2.0 * square - 1.0) * WINDOW.yz) - s.p;
    return windowLight(s, square, weighted) / skyLight(normalize(to));
}

vec3 pathLight(Ray ray)
{
    vec3 light = vec3(0.0), carried = vec3(1.0);
    float density = 0.0;
    for (int k = 0; k <= bounces + 1; k++) {
        Surface s = roomSurface(ray, hitThreshold, maxSteps);
        if (s.open) {
            float far = (OUTSIDE - ray.origin.x) / ray.direction.x;
            float both = density / (density + windowDensity(ray.direction, far));
            float weight = k == 0 || lights == 0 ? 1.0 : (lights == 1 ? 0.0 : both);
            light += weight * carried * 1.0;
            break;
        }
        light += carried * (1.0 - white);
        if (k > bounces)
            break;
        carried *= white;
        if (lights > 0)
            light += carried * windowOfOne(s, chance(4 * k + 2), lights == 2);
        if (roulette && k > 0) {
            float stay = min(1.5 * max(carried.r, max(carried.g, carried.b)), 1.0);
            if (chance(4 * k + 4).x >= stay)
                break;
            carried /= stay;
        }
        ray = Ray(s.p + 3.0 * hitThreshold * s.normal, cosineDirection(s.normal, chance(4 * k + 3)));
        density = lambert(s.normal, ray.direction) / PI;
    }
    return light;
}

vec4 frameKept(vec2 pixel)
{
    vec3 light = pathLight(pixelRay(screenPosition(pixel + chance(0) - 0.5)));
    return vec4(mix(texelFetch(history, iPixel, 0).rgb, light, 1.0 / float(iFrame + 1)), 1.0);
}

vec3 rayColour(Ray ray)
{
    roomSurface(ray, hitThreshold, maxSteps); // for the views
    return 0.5 * texelFetch(history, iPixel, 0).rgb;
}
