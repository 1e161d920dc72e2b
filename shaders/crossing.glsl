// crossing.glsl - sphere tracing with a cone: a march that ends at the same point wherever it began.
#include "march.glsl"

const float CROSSING_SHORT = 0.7; // a step is shorter than the distance by this many thresholds

// March along a ray as marchCone of cone.glsl does, and find where the scene's distance first falls to the
// threshold r(t) = threshold + spread t. marchCone ends somewhere within the threshold, at a point that depends
// on where it began.
//   ray, tMin, tMax, threshold, spread, maxSteps  those of marchCone
//   formula  a step is h = d - 0.7 r, so no point of the step is nearer to the scene than 0.7 r. The first
//            step with d < r is the last. There the gap is g = d - r, and one step earlier the gap was
//            g' = h - 0.3 r', where r' is the earlier threshold. The straight line between the two gaps is
//            0 at t + h g / (g' - g)
//   returns  found, and this zero as t, on the near side of the surface. It is exact where distance and threshold
//            change at a constant rate, as in front of a wall. If the second derivative of d is at most K and g
//            falls by at least s per unit, the error is at most K h^2 / (8 s). If the first step is
//            a hit, t is tMin
// The march needs a lower bound of the distance: then it steps over no surface, and over nothing that comes nearer
// to the ray than 0.988 r. march and marchCone guarantee only 0.86 r. A surface that comes within r but no nearer than
// 0.988 r may or may not be found. The march takes a few more steps than marchCone: one to three in front of a wall.
// docs/16_fewer_steps.md has the proofs.
Hit marchCrossing(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, spread);
    float t = tMin, distance = 0.0, advance = 0.0;
    int steps = 0;
    bool found = false;
    bool searching = tMin < tMax;
    while (searching) {
        distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        float radius = threshold + spread * t;
        found = distance < radius;
        advance = found ? advance : distance - CROSSING_SHORT * radius;
        t += found ? 0.0 : advance;
        searching = !found && t < tMax && steps < maxSteps;
    }
    float gap = distance - threshold - spread * t;
    float before = advance - (1.0 - CROSSING_SHORT) * (threshold + spread * (t - advance));
    t += found && advance > 0.0 ? advance * gap / (before - gap) : 0.0;
    int end = found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS);
    traceMarch(steps, t, end);
    return Hit(found, t);
}
