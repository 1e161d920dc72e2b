// Solution to exercise 24.1: the share of the light that has bounced.
#include "main.glsl"
#define pathLight chapterPathLight
#define frameKept chapterFrameKept
#define rayColour chapterRayColour
#include "24_bounces.frag"
#undef pathLight
#undef frameKept
#undef rayColour

// The light that has bounced, and all light, both summed over the three channels.
vec2 pathLight(Ray ray)
{
    vec3 light = vec3(0.0), straight = vec3(0.0), carried = vec3(1.0);
    float density = 0.0;
    for (int k = 0; k <= bounces + 1; k++) {
        Surface s = roomSurface(ray, hitThreshold, maxSteps);
        if (s.open) {
            float far = (OUTSIDE - ray.origin.x) / ray.direction.x;
            float both = density / (density + windowDensity(ray.direction, far));
            float weight = k == 0 || lights == 0 ? 1.0 : (lights == 1 ? 0.0 : both);
            light += weight * carried * skyLight(ray.direction);
            straight = k < 2 ? light : straight;
            break;
        }
        if (k > bounces)
            break;
        carried *= s.colour;
        vec3 direct = sunLight(s, chance(4 * k + 1));
        if (lights > 0)
            direct += windowLight(s, chance(4 * k + 2), lights == 2);
        light += carried * direct;
        straight = k == 0 ? light : straight;
        if (roulette && k > 0) {
            float stay = min(1.5 * max(carried.r, max(carried.g, carried.b)), 1.0);
            if (chance(4 * k + 4).x >= stay)
                break;
            carried /= stay;
        }
        ray = Ray(s.p + 3.0 * hitThreshold * s.normal, cosineDirection(s.normal, chance(4 * k + 3)));
        density = lambert(s.normal, ray.direction) / PI;
    }
    return vec2(dot(light - straight, vec3(1.0)), dot(light, vec3(1.0)));
}

vec4 frameKept(vec2 pixel)
{
    vec2 light = pathLight(pixelRay(screenPosition(pixel + chance(0) - 0.5)));
    return vec4(mix(texelFetch(history, iPixel, 0).rg, light, 1.0 / float(iFrame + 1)), 0.0, 1.0);
}

vec3 rayColour(Ray ray)
{
    roomSurface(ray, hitThreshold, maxSteps); // for the views
    vec2 light = texelFetch(history, iPixel, 0).rg;
    return vec3(light.y > 0.0 ? light.x / light.y : 0.0);
}
