// march.glsl - sphere tracing: advance along a ray by the scene's distance until the scene is near.
#include "scene.glsl"

// The result of a march.
struct Hit {
    bool  found; // the scene was nearer than the threshold
    float t;     // where the march ended, in scene units along the ray
};

// March along a ray: t_0 = tMin, t_(n+1) = t_n + distanceAt(point at t_n).
//   ray        direction of length 1
//   tMin, tMax where to start, and the distance along the ray that ends the search, scene units;
//              an empty interval (tMin >= tMax) is a miss that costs nothing
//   threshold  a distance below which the surface counts as reached, scene units, > 0
//   maxSteps   evaluations before the march gives up, at least 1
//   returns    if found, t is the first point of the march at which the scene is nearer than threshold. This point is
//              never behind a flat surface, and at most threshold / |cos a| in front of the surface along the ray,
//              where a is the angle between the ray and the normal
// The march needs a scene distance that is a lower bound of the true distance; then it steps over no surface.
// Source: J. C. Hart, 'Sphere tracing', The Visual Computer 12 (1996); report, section 1.4.
Hit march(Ray ray, float tMin, float tMax, float threshold, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, 0.0);
    float t = tMin;
    int steps = 0;
    bool found = false;
    bool searching = tMin < tMax;
    while (searching) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        found = distance < threshold;
        t += found ? 0.0 : distance;
        searching = !found && t < tMax && steps < maxSteps;
    }
    int end = found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS);
    traceMarch(steps, t, end);
    return Hit(found, t);
}
