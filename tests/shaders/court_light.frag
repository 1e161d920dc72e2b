// For tests/lib/paths.c: the light that arrives at a surface of chapter 14, relative to that of an open floor, divided
// by 2: from one path of light for each sample under a uniform sky, or the chapter's.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

uniform int what; // 0 in [0, 2]: 0 paths, 1 the chapter's series, 2 whether the sample shows the sky, and its true openness

const int MOST = 12; // surfaces after the first

// courtyardSurface for a ray that does not come from the eye: without the footprint of a pixel.
Surface nextSurface(Ray ray)
{
    vec2 interval = boxInterval(ray, COURT_LOW, COURT_HIGH);
    float trough = troughReached(ray);
    Hit hit = march(ray, interval.x, min(interval.y, trough), hitThreshold, maxSteps);
    float t = hit.found ? hit.t : trough, radius = 2.0 * hitThreshold;
    vec3 p = ray.origin + t * ray.direction;
    bool onTrough = !hit.found && t < COURT_FAR, ground = p.y < COURT_SIDE - abs(p.x);
    vec3 straight = ground ? vec3(0.0, 1.0, 0.0) : vec3(-sign(p.x), 0.0, 0.0);
    vec3 normal = hit.found ? normalAt(p, radius) : straight;
    vec3 colour = onTrough && ground ? pavingColour(p, vec2(0.001)) : courtyardColour(p, radius);
    return Surface(!hit.found && !onTrough, p, normal, colour, radius);
}

vec3 arriving(Surface s)
{
    vec3 light = vec3(0.0), carried = vec3(1.0);
    for (int k = 0; k <= MOST; k++) {
        vec3 onward = cosineDirection(s.normal, vec2(pixelRandom(2 * k), pixelRandom(2 * k + 1)));
        s = nextSurface(shadowRay(s.p, s.normal, onward, 2.0 * s.radius));
        if (s.open) {
            light += onward.y > 0.0 ? carried : vec3(0.0);
            break;
        }
        carried *= s.colour;
    }
    return light;
}

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Surface s = courtyardSurface(ray, hitThreshold, maxSteps);
    vec3 light = arriving(s);
    lookingRound = true;
    float truth = openTruly(s, what == 2 && !s.open ? 2 : 0);
    vec3 series = skyAndBounces(openQuickly(s), NEAR, 2);
    return what == 2 ? vec3(s.open, truth, 0.0) : (what == 0 ? light : series) / 2.0;
}
