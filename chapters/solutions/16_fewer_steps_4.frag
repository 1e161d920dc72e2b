// Solution to exercise 16.4: the last two distances show how fast the distance falls, and so how
// far the next step may go. After a step back, the march uses longer steps again.
#include "main.glsl"
#include "relaxed.glsl"
Hit marchBySlope(Ray ray, float tMin, float tMax, float threshold, float spread, float most, int maxSteps);
#define marchRelaxed marchBySlope
#include "16_fewer_steps.frag"

Hit marchBySlope(Ray ray, float tMin, float tMax, float threshold, float spread, float most, int maxSteps)
{
    traceBegin(tMin, tMax);
    float t = tMin, covered = tMin, lastT = tMin, lastDistance = 0.0;
    bool found = false;
    int steps = 0;
    for (; steps < maxSteps && covered < tMax && !found; steps++) {
        float distance = distanceAt(ray.origin + t * ray.direction), r = threshold + spread * t;
        traceStep(steps, t, distance);
        float slope = t > lastT ? clamp((lastDistance - distance) / (t - lastT), -0.5, 1.0) : 1.0;
        float overlap = covered - (t - distance), needed = 0.5 * r * r * (1.0 / lastDistance + 1.0 / max(distance, 1e-9));
        bool first = t <= covered;
        found = distance < r && t < tMax && (first || overlap >= 0.0);
        if (found)
            continue;
        if (first || overlap >= needed) {
            lastT = t;
            lastDistance = distance;
            covered = t + distance;
            t = min(t + clamp(2.0 / (1.0 + slope), 1.0, most) * distance, tMax);
        } else {
            t = covered;
        }
    }
    t = found ? t : covered;
    traceMarch(steps, t, found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS));
    return Hit(found, t);
}
