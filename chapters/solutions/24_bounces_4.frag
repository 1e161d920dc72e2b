// Solution to exercise 24.4: the patch of the sun is connected with every surface of a path, bars included.
#include "main.glsl"
#define pathLight chapterPathLight
#define frameKept chapterFrameKept
#define rayColour chapterRayColour
#include "24_bounces.frag"
#undef pathLight
#undef frameKept
#undef rayColour

// The direction to a point of the sun's disc.
vec3 sunDirection(vec2 square)
{
    return lampDirection(TO_SUN, SUN_RADIUS, discPoint(square));
}

// The light that a surface receives from one point of the patch that the sun draws in the room: the point where a ray of
// the sun ends that has come through a random point of the window. The weight is that of this point, because a path that
// bounces may find the patch by itself.
vec3 patchLight(Surface s, int k)
{
    vec3 down = -sunDirection(chance(300 + 2 * k)), at = vec3(OUTSIDE, WINDOW_AT.yz + (2.0 * chance(301 + 2 * k) - 1.0) * WINDOW.yz);
    Surface lit = roomSurface(Ray(at + 1e-4 * down, down), hitThreshold, maxSteps);
    vec3 from = s.p + 3.0 * hitThreshold * s.normal, to = lit.p - from;
    float far = length(to), here = lambert(s.normal, to / far), there = lambert(lit.normal, -to / far), facing = lambert(lit.normal, -down);
    Ray ray = Ray(from, to / far);
    vec2 interval = boxInterval(ray, THINGS_LOW, THINGS_HIGH);
    float reach = here * there * facing > 0.0 ? far - 6.0 * hitThreshold : 0.0;
    bool free = !march(ray, interval.x, min(interval.y, reach), hitThreshold, maxSteps).found && wallReached(ray).t > reach;
    float byPatch = facing / (WINDOW_AREA * down.x) * far * far / max(there, 1e-6), byCosine = here / PI;
    return reach > 0.0 && free ? lit.colour * SUN * facing * byCosine / (byPatch + byCosine) : vec3(0.0);
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
            light += weight * carried * skyLight(ray.direction);
            break;
        }
        if (k > bounces)
            break;
        carried *= s.colour;
        vec3 toSun = sunDirection(chance(4 * k + 1)), direct = sunLight(s, chance(4 * k + 1));
        float byPatch = lambert(s.normal, toSun) / (WINDOW_AREA * -toSun.x) * s.t * s.t / max(lambert(s.normal, -ray.direction), 1e-6);
        direct *= k > 0 ? density / (density + byPatch) : 1.0;
        if (k < bounces)
            direct += patchLight(s, k);
        if (lights > 0)
            direct += windowLight(s, chance(4 * k + 2), lights == 2);
        light += carried * direct;
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
    return encodeSRGB(filmCurve(exposed(texelFetch(history, iPixel, 0).rgb, exposure), 1.25, 9.0));
}
