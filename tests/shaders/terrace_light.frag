// For tests/lib/paths.c: the light that leaves a surface of chapter 13, divided by 8: without what comes straight from
// the sun, from one path of light for each sample or the chapter's, or only what comes straight from the sun.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour
#include "occlusion.glsl"

uniform int what; // 0 in [0, 4]: 0 paths, 1 the ambient light, 2 the sky, 3 the sun by one ray, 4 by its share

const int MOST = 6; // surfaces after the first; another one would add less than 1 %

// surfaceAt for a ray that does not come from the eye: without the footprint of a pixel, which would thicken the posts.
Surface nextSurface(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    float ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : FAR;
    Hit hit = march(ray, interval.x, min(interval.y, ground), hitThreshold, maxSteps);
    float t = hit.found ? hit.t : min(ground, FAR), radius = 2.0 * hitThreshold;
    vec3 p = ray.origin + t * ray.direction;
    vec3 normal = hit.found ? normalAt(p, radius) : vec3(0.0, 1.0, 0.0);
    bool open = !hit.found && (t >= FAR || p.z < EDGE);
    vec3 stone = p.x > 2.5 && p.z > -4.92 ? SANDSTONE : STONE;
    return Surface(open, p, normal, hit.found ? stone : floorColour(p, vec2(0.001)), radius);
}

// The light that arrives from a point of the sun.
vec3 straight(Surface s, vec3 toSun, vec2 square)
{
    Ray ray = sunRay(s, lampDirection(toSun, spread, discPoint(square)));
    float seen = lightReaching(ray, sunReach(s, ray), hitThreshold, maxSteps);
    return SUN_COLOUR * lambert(s.normal, ray.direction) * seen;
}

// The light that arrives from the sky and from other surfaces, from one path.
vec3 arriving(Surface s, vec3 toSun)
{
    vec3 light = vec3(0.0), carried = vec3(1.0);
    for (int k = 0; k <= MOST; k++) {
        vec3 onward = cosineDirection(s.normal, vec2(pixelRandom(4 * k), pixelRandom(4 * k + 1)));
        s = nextSurface(shadowRay(s.p, s.normal, onward, 2.0 * s.radius));
        if (s.open) {
            light += carried * skyLight(onward, toSun);
            break;
        }
        carried *= s.colour;
        light += carried * straight(s, toSun, vec2(pixelRandom(4 * k + 2), pixelRandom(4 * k + 3)));
    }
    return light;
}

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface s = surfaceAt(ray);
    vec3 light = what == 0   ? arriving(s, toSun)
                 : what == 3 ? straight(s, toSun, vec2(pixelRandom(0), pixelRandom(1)))
                 : what == 4 ? SUN_COLOUR * lambert(s.normal, toSun) * sunSeen(s, toSun)
                             : ambientLight(s.normal);
    return what == 2 ? vec3(s.open) : s.colour * light / 8.0;
}
