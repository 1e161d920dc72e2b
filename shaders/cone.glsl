// cone.glsl - sphere tracing with a cone in place of a line: what is smaller than a pixel counts as
// reached.
//
// Two loops beside that of march: one for all takes the chapters that use it up to 5 % longer.
#include "camera.glsl"
#include "march.glsl"

// How fast a pixel's ray widens: half the side of a pixel, seen from the eye, per scene unit along
// the view direction.
//   formula  1 / (iResolution.y focalLength): the screen is 2 high, focalLength in front of the eye
float pixelSpread()
{
    return 1.0 / (iResolution.y * focalLength);
}

// march of march.glsl with a threshold that grows along the ray: a surface counts as reached where
// the scene is nearer than threshold + spread t.
//   spread   how fast the threshold grows, per scene unit, >= 0; pixelSpread() for the footprint of
//            a pixel; with 0 it is march
//   others, and what it returns  those of march
// Source: J. Amanatides, 'Ray tracing with cones', SIGGRAPH 1984; report, section 3.3, where its
// lack is seen as sparkle.
Hit marchCone(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, spread);
    float t = tMin;
    int steps = 0;
    bool found = false;
    bool searching = tMin < tMax;
    while (searching) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        found = distance < threshold + spread * t;
        t += found ? 0.0 : distance;
        searching = !found && t < tMax && steps < maxSteps;
    }
    int end = found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS);
    traceMarch(steps, t, end);
    return Hit(found, t);
}

// The share of the light that arrives from a lamp with a width, by the same idea: a cone from the
// surface to the lamp. 1 where no step found anything in its cone, 0 where a surface stands on the
// axis, grey where something stands beside it.
//   ray         from shadowRay
//   tMin, tMax  where to look, scene units; an empty interval is free and returns 1
//   threshold   radius of the cone where it starts, scene units, > 0
//   spread      how fast it widens, per scene unit: the tangent of half the angle under which the
//               lamp is seen
//   formula     (s - 0.2) / 0.8, at least 0, s the smallest of distance / (threshold + spread t) over
//               the steps, at most 1; what is dark at a fifth need not be marched to its end
// Needs a lower bound of the distance. The greys are a model, no measured area.
float coneReaching(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    traceBegin(tMin, tMax);
    float t = tMin;
    int steps = 0;
    float smallest = 1.0;
    bool searching = tMin < tMax;
    while (searching) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        smallest = min(smallest, distance / (threshold + spread * t));
        t += distance;
        searching = smallest > 0.2 && t < tMax && steps < maxSteps;
    }
    return max((smallest - 0.2) / 0.8, 0.0);
}
