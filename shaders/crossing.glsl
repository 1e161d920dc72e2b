// crossing.glsl - sphere tracing with a cone that ends in one place, wherever it began.
#include "march.glsl"

const float CROSSING_SHORT = 0.7; // thresholds by which a step falls short of the distance

// Walk along a ray as marchCone of cone.glsl does, and find where the scene's distance first falls to the
// threshold r(t) = threshold + spread t. marchCone ends anywhere within it, and begun elsewhere it ends
// elsewhere.
//   ray, tMin, tMax, threshold, spread, maxSteps  those of marchCone
//   formula  a step is h = d - 0.7 r, so no place on the way is nearer to the scene than 0.7 r. The first
//            place with d < r ends it. There the gap is g = d - r, and at the place before it was
//            g' = h - 0.3 r', r' the threshold there. The straight line between them is 0 at
//            t + h g / (g' - g)
//   returns  found, and t: that place, on the near side of the surface. Exact where distance and threshold
//            change at one rate, as before a wall; where the second derivative of d is at most K and g
//            falls by s or more for each unit, off by at most K h^2 / (8 s). Where the first place is a
//            hit, t is tMin
// Needs a lower bound of the distance: then no surface is stepped over, nor anything that comes nearer to the
// ray than 0.988 r. march and marchCone promise 0.86 r. What comes as near as r, and no nearer than that, may
// be met or not. Takes some more steps than marchCone: one to three before a wall.
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
