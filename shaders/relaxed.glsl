// relaxed.glsl - over-relaxed sphere tracing: longer steps, and a step back if one was too long.
#include "march.glsl"

// March along a ray with steps of omega times the distance. A step is right if the balls of empty space around
// its two ends overlap far enough; if they do not, a surface may lie between the ends. Then the march goes
// back to where the first ball ends, and continues as march does.
//   ray        direction of length 1
//   tMin, tMax where to start, and the distance along the ray that ends the search, scene units; an empty
//              interval is a miss that costs nothing
//   threshold, spread  a surface counts as reached where the scene is nearer than r = threshold + spread t,
//              scene units and scene units per scene unit, > 0 and >= 0; with spread pixelSpread(), r is
//              the footprint of a pixel
//   omega      length of a step divided by the distance, 1 <= omega < 2; 1 gives march, or marchCone
//   maxSteps   evaluations before the march gives up, at least 1
//   formula    the ray is known to be empty from tMin to covered. At t, with the distance d there and D at the
//              step before, the gap between the balls is t - d - covered. The step was right if
//              gap <= -(r^2 / 2) (1 / D + 1 / d), or if d < r and gap <= 0: a hit. Then covered becomes
//              t + d, and the next point is t + omega d, tMax at most
//   returns    if found, t is a point where the scene is nearer than r, and no surface lies in front of that point;
//              otherwise t is covered, because the march gave up or passed tMax
// The march needs a lower bound of the distance: then it steps over no surface, and over nothing that comes nearer
// to the ray than 0.86 r, which is all that march guarantees. If the distance is also 1-Lipschitz along the ray,
// marchRelaxed takes at most n + 1 evaluations where march takes n. A ray that only grazes a surface, coming nearer
// than r and moving away again, may be a hit for one of the two functions and a miss for the other.
// Source: B. Keinert and others, 'Enhanced sphere tracing', STAG 2014; docs/16_fewer_steps.md has the proofs
// and lists the differences.
Hit marchRelaxed(Ray ray, float tMin, float tMax, float threshold, float spread, float omega,
                 int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, spread);
    float t = tMin, covered = tMin, before = 1.0, factor = omega;
    int steps = 0;
    bool found = false;
    bool searching = tMin < tMax;
    while (searching) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        float radius = threshold + spread * t, square = 0.5 * radius * radius;
        float gap = t > covered ? t - distance - covered : -1e9;
        found = distance < radius && gap <= 0.0 && t < tMax;
        bool back = !found && gap > -square / before - square / max(distance, 1e-9);
        factor = back ? 1.0 : factor;
        before = distance;
        covered = back || found ? covered : t + distance;
        t = back ? covered : (found ? t : min(t + factor * distance, tMax));
        searching = !found && covered < tMax && steps < maxSteps;
    }
    t = found ? t : covered;
    int end = found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS);
    traceMarch(steps, t, end);
    return Hit(found, t);
}
