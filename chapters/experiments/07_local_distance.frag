// Experiment of chapter 07: the exit test of the report's annex, which ends a ray when the distance
// to the scene is 20 or more. In an endless field no distance is that large, so every ray that hits
// nothing goes on until it runs out of steps.
//
// A macro replaces the chapter's call to marchCone with a call to marchLocal.
#include "main.glsl"
#include "cone.glsl"

Hit marchLocal(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    traceBegin(tMin, tMax);
    float t = tMin;
    int steps = 0;
    float distance = 0.0;
    bool found = false;
    do {
        distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        found = distance < threshold + spread * t;
        t += found ? 0.0 : distance;
    } while (!found && distance < 20.0 && steps < maxSteps);
    traceMarch(steps, t, found ? END_HIT : (distance < 20.0 ? END_STEPS : END_PASSED));
    return Hit(found && t < tMax, t);
}

#define marchCone marchLocal
#include "07_repetition.frag"
