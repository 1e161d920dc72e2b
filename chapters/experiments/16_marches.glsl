// Eight marches, one of which replaces the first march of a chapter. A file that includes this one before the
// chapter chooses the march with, for example, #define MARCH ENHANCED. All other marches of the pixel find nothing and
// cost nothing.
//
// All but CONE and TIGHT end where the distance is less than the chapter's threshold, and ignore the growth of the
// threshold along the ray, so that they end equally close to the surface. Each march assumes a lower bound of the
// distance. docs/benchmark.md compares the marches.
#include "cone.glsl"    // march, marchCone, pixelSpread
#include "relaxed.glsl" // marchRelaxed, which some chapters call
#include "coarse.glsl"  // coarseStart

#define PLAIN    0
#define RELAXED  1
#define ENHANCED 2
#define SEGMENT  3
#define OVERSTEP 4
#define CONE     5
#define COARSE   6
#define TIGHT    7

#ifndef MARCH
#define MARCH PLAIN
#endif

const int MARCH_STEPS = 4096;

uniform bool numbers; // false: show evaluations, depth and hit of the first march as numbers for the tests

// An upper bound of how fast the scene's distance can fall along a segment of a ray: the largest -d'(t), per scene
// unit, at most 1. A scene that has a better bound than 1 defines FALL_KNOWN and this function.
//   p, v    start and direction of the segment
//   reach   length of the segment, scene units, > 0
float fallAlong(vec3 p, vec3 v, float reach);

#ifndef FALL_KNOWN
float fallAlong(vec3 p, vec3 v, float reach)
{
    return 1.0;
}
#endif

// Report to the views how a march ended.
Hit marchEnded(bool found, float t, float tMax, int steps)
{
    traceMarch(steps, t, found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS));
    return Hit(found, t);
}

// In the formulas, d is the distance at t, and the march begins with t = tMin.

// RELAXED: over-relaxation.
//   formula  t + omega d, 1 <= omega < 2. If the balls around the two points do not touch, the march goes back to
//            the end of the first ball, and omega = 1 from then on
//   bound    at most n + 1 evaluations where the plain march takes n, for a 1-Lipschitz distance
//   safe     for all lower bounds. The balls may just touch, whereas marchRelaxed requires them to overlap
// Source: B. Keinert and others, 'Enhanced sphere tracing', STAG 2014.
Hit marchKeinert(Ray ray, float tMin, float tMax, float threshold, float omega, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, 0.0);
    float t = tMin, covered = tMin;
    int steps = 0;
    bool found = false, searching = tMin < tMax;
    while (searching) {
        float d = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, d);
        steps++;
        bool back = t > covered && t - d > covered;
        found = d < threshold && !back && t < tMax;
        omega = back ? 1.0 : omega;
        covered = back || found ? covered : t + d;
        t = back ? covered : (found ? t : min(t + omega * d, tMax));
        searching = !found && covered < tMax && steps < maxSteps;
    }
    return marchEnded(found, found ? t : covered, tMax, steps);
}

// ENHANCED: the step that would be right if the surface were a plane.
//   formula  the last two points that were not rejected, t' and t, give the slope s = (d' - d) / (t - t'). If the
//            slope stays the same, the balls around t and the next point touch after a step of
//            d + d (1 - s) / (1 + s); the second term is multiplied by omega, 0 <= omega <= 1. If the balls do not
//            touch, the march rejects the point and goes back, as RELAXED does, but the next step is relaxed again
//   bound    at most 2 n - 2 evaluations where the plain march takes n >= 2, for a 1-Lipschitz distance
//   safe     for all lower bounds
// Source: C. Balint, G. Valasek, 'Accelerating sphere tracing', Eurographics 2018. The clamp on s is not in the source:
// at s = -1, where the ray moves straight away from the surface, the step would be infinite.
Hit marchEnhanced(Ray ray, float tMin, float tMax, float threshold, float omega, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, 0.0);
    float t = tMin, covered = tMin, before = 0.0, at = tMin;
    int steps = 0;
    bool found = false, searching = tMin < tMax;
    while (searching) {
        float d = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, d);
        steps++;
        bool back = t > covered && t - d > covered;
        found = d < threshold && !back && t < tMax;
        float slope = t > at ? clamp((before - d) / (t - at), -0.9, 1.0) : 1.0;
        before = back ? before : d;
        at = back ? at : t;
        covered = back || found ? covered : t + d;
        float advance = d + omega * d * (1.0 - slope) / (1.0 + slope);
        t = back ? covered : (found ? t : min(t + advance, tMax));
        searching = !found && covered < tMax && steps < maxSteps;
    }
    return marchEnded(found, found ? t : covered, tMax, steps);
}

// SEGMENT: a bound of the slope on a segment of the ray instead of everywhere.
//   formula  s = fallAlong on the next segment, of length h: no surface lies on this segment before t + d / s. The
//            step is min(d / s, h), and the next segment is twice as long as the step
//   bound    where s = 1, the march is plain. Each step also computes s, which costs about as much as d
//   safe     if s is a bound; where the distance is convex along the ray, as in front of one convex body,
//            -d'(t) at the start is such a bound
// Source: E. Galin, E. Guerin, A. Paris, A. Peytavie, 'Segment tracing using local Lipschitz bounds', Eurographics
// 2020.
Hit marchSegment(Ray ray, float tMin, float tMax, float threshold, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, 0.0);
    float t = tMin, reach = tMax - tMin;
    int steps = 0;
    bool found = false, searching = tMin < tMax;
    while (searching) {
        vec3 p = ray.origin + t * ray.direction;
        float d = distanceAt(p);
        traceStep(steps, t, d);
        steps++;
        found = d < threshold;
        float fall = clamp(fallAlong(p, ray.direction, reach), 1e-6, 1.0);
        float advance = min(d / fall, reach);
        t += found ? 0.0 : advance;
        reach = max(min(2.0 * advance, tMax - t), 1e-6);
        searching = !found && t < tMax && steps < maxSteps;
    }
    return marchEnded(found, t, tMax, steps);
}

// OVERSTEP: long steps that nothing checks, and bisection once a surface has been passed.
//   formula  t + omega d, until d < 0; then the interval from the last point outside to this point is halved repeatedly
//   bound    none: a body thinner than (omega - 1) d may be stepped over
//   safe     never, for omega > 1
// The method is older than sphere tracing; any fixed-step march with bisection is of this kind.
Hit marchOverstep(Ray ray, float tMin, float tMax, float threshold, float omega, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, 0.0);
    float t = tMin, outside = tMin, inside = tMax;
    bool passed = false;
    int steps = 0;
    bool found = false, searching = tMin < tMax;
    while (searching) {
        float d = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, d);
        steps++;
        found = d < threshold && (d >= 0.0 || t == tMin);
        passed = passed || d < 0.0;
        outside = d < 0.0 ? outside : t;
        inside = d < 0.0 ? t : inside;
        t = found ? t : (passed ? 0.5 * (outside + inside) : t + omega * d);
        searching = !found && t < tMax && steps < maxSteps;
    }
    return marchEnded(found, t, tMax, steps);
}

// TIGHT: march with a threshold near the least that floats allow, to find the true hit. At a grazing angle, this march
// ends far in front of the surface, so it then continues until the ray is inside or leaves the surface again. Another
// march that ends there or earlier has not missed the surface.
Hit marchTight(Ray ray, float tMin, float tMax)
{
    Hit hit = marchCone(ray, tMin, tMax, 1e-5, 1e-6, MARCH_STEPS);
    float least = 1e-5 + 1e-6 * hit.t, d = 0.0;
    for (int i = 0; i < 512 && hit.found && d > -least && d < 4.0 * least; i++) {
        d = distanceAt(ray.origin + hit.t * ray.direction);
        hit.t += 8.0 * least;
    }
    return hit;
}

// CONE is marchCone with the footprint of a pixel, and COARSE is march from where the coarse pass ended. Their sources
// are named in cone.glsl and coarse.glsl.
Hit marchChosen(Ray ray, float tMin, float tMax, float threshold)
{
#if MARCH == RELAXED
    return marchKeinert(ray, tMin, tMax, threshold, 1.2, MARCH_STEPS);
#elif MARCH == ENHANCED
    return marchEnhanced(ray, tMin, tMax, threshold, 0.9, MARCH_STEPS);
#elif MARCH == SEGMENT
    return marchSegment(ray, tMin, tMax, threshold, MARCH_STEPS);
#elif MARCH == OVERSTEP
    return marchOverstep(ray, tMin, tMax, threshold, 1.5, MARCH_STEPS);
#elif MARCH == CONE
    return marchCone(ray, tMin, tMax, threshold, pixelSpread(), MARCH_STEPS);
#elif MARCH == COARSE && !defined PASS_DONE
    return march(ray, max(tMin, coarseStart(ray)), tMax, threshold, MARCH_STEPS);
#elif MARCH == TIGHT
    return marchTight(ray, tMin, tMax);
#else
    return march(ray, tMin, tMax, threshold, MARCH_STEPS);
#endif
}

int marchesBegun = 0, evaluationsOfMarch = 0;
Hit hitOfMarch = Hit(false, 0.0);

Hit firstMarch(Ray ray, float tMin, float tMax, float threshold)
{
    Hit hit = Hit(false, tMax);
    if (marchesBegun == 0) {
        int before = trace.evaluations;
        hit = marchChosen(ray, tMin, tMax, threshold);
        evaluationsOfMarch = trace.evaluations - before;
        hitOfMarch = hit;
    }
    marchesBegun++;
    return hit;
}

// The colour of chapter 16 for a number of evaluations.
vec3 marchCountColour(int count)
{
    const vec3 colours[5] = vec3[5](vec3(0.05, 0.04, 0.15), vec3(0.24, 0.16, 0.43), vec3(0.62, 0.27, 0.46),
                                    vec3(0.94, 0.55, 0.37), vec3(1.00, 0.95, 0.72));
    float x = min(float(count) / 16.0, 3.999);
    int i = int(x);
    return mix(colours[i], colours[i + 1], x - float(i));
}

// The colour of a pixel: the number of evaluations, from night blue for 0 to straw for 64 or more; or three numbers in
// [0, 1] if the parameter `numbers` is on.
vec3 marchColour()
{
    int end = hitOfMarch.found ? END_HIT : (hitOfMarch.t >= trace.interval.y ? END_PASSED : END_STEPS);
    trace.steps = evaluationsOfMarch, trace.t = hitOfMarch.t, trace.end = end;
    return numbers ? vec3(float(evaluationsOfMarch) / 4096.0, hitOfMarch.t / 1024.0, float(hitOfMarch.found))
                   : marchCountColour(evaluationsOfMarch);
}

#define march(ray, tMin, tMax, threshold, steps) firstMarch(ray, tMin, tMax, threshold)
#define marchCone(ray, tMin, tMax, threshold, spread, steps) firstMarch(ray, tMin, tMax, threshold)
#define marchRelaxed(ray, tMin, tMax, threshold, spread, omega, steps) firstMarch(ray, tMin, tMax, threshold)
#define marchReef(ray, tMin, tMax, threshold, spread, steps) firstMarch(ray, tMin, tMax, threshold)
