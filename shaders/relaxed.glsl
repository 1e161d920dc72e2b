// relaxed.glsl - sphere tracing that asks ahead: longer steps, and a way back where one was too long.
#include "march.glsl"

// Walk along a ray by omega times the distance. A step is right where the balls of empty space round its
// two ends overlap far enough; where they do not, something may stand between them. Then the walk goes
// back to where the first ball ends, and on as march does.
//   ray        direction of length 1
//   tMin, tMax where to start and the distance travelled that ends the search, scene units; an empty
//              interval is a miss that costs nothing
//   threshold, spread  a surface counts as reached where the scene is nearer than r = threshold + spread t,
//              scene units and scene units per scene unit, > 0 and >= 0; with spread pixelSpread() that is
//              the footprint of a pixel
//   omega      length of a step in distances, 1 <= omega < 2; with 1 it is march, and marchCone
//   maxSteps   evaluations before the ray is given up, at least 1
//   formula    nothing stands from tMin to covered. At t, with the distance d there and D at the step
//              before, the gap between the balls is t - d - covered. The step was right where
//              gap <= -(r^2 / 2) (1 / D + 1 / d), or where d < r and gap <= 0: a hit. Then covered is
//              t + d, and t + omega d the next place, tMax at most
//   returns    found: a place where the scene is nearer than r; no surface stands in front of it.
//              t: that place, or covered, where the march was given up or has passed tMax
// Needs a lower bound of the distance: then no surface is stepped over, nor anything that comes nearer to
// the ray than 0.86 r, and march promises no more. Where the distance is also 1-Lipschitz along the ray, at
// most n + 1 evaluations where march takes n; but a ray that only grazes, nearer than r and away again, may be
// a hit for one of them and none for the other.
// Source: B. Keinert and others, 'Enhanced sphere tracing', STAG 2014; docs/16_fewer_steps.md has the proofs
// and what is different here.
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
