// Solution to exercise 24.2: a lamp hangs in the room, a point that shines on every surface of a path.
#include "main.glsl"
#define pathLight chapterPathLight
#define frameKept chapterFrameKept
#define rayColour chapterRayColour
#include "24_bounces.frag"
#undef pathLight
#undef frameKept
#undef rayColour

const vec3 LAMP_AT = vec3(0.95, 1.45, -0.75), LAMP = vec3(0.45, 0.28, 0.12); // light at a distance of 1, linear RGB

vec3 lampLight(Surface s)
{
    vec3 to = LAMP_AT - s.p, from = s.p + 3.0 * hitThreshold * s.normal;
    float facing = lambert(s.normal, normalize(to)), far = distance(from, LAMP_AT);
    Ray ray = Ray(from, (LAMP_AT - from) / far);
    vec2 interval = boxInterval(ray, THINGS_LOW, THINGS_HIGH);
    bool free = from.x > -ROOM.x || inWindow((from + (-ROOM.x - from.x) / ray.direction.x * ray.direction).yz);
    bool found = march(ray, interval.x, min(interval.y, facing > 0.0 && free ? far : 0.0), hitThreshold, maxSteps).found;
    return free && !found ? facing * fallOff(length(to), 1.0) * LAMP : vec3(0.0);
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
        vec3 direct = sunLight(s, chance(4 * k + 1));
        if (lights > 0)
            direct += windowLight(s, chance(4 * k + 2), lights == 2);
        light += carried * (direct + lampLight(s));
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
