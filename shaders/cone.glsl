// cone.glsl - sphere tracing with a cone instead of a line: a surface closer to the ray than half a pixel
// counts as reached.
//
// The two loops below are separate from the loop of march, because a shared loop would make the chapters that use it up
// to 5 % slower.
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
//   spread   how fast the threshold grows, per scene unit, >= 0; pixelSpread() gives the footprint of
//            a pixel, and 0 gives march
//   the other parameters and the result are those of march
// Source: J. Amanatides, 'Ray tracing with cones', SIGGRAPH 1984; report, section 3.3, where pictures
// without a cone sparkle.
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

// The visible share of an extended lamp, found with a cone from the surface to the lamp: 1 if no step
// found anything in the cone, 0 if a surface crosses the axis, in between if a surface is beside the axis.
//   ray         from shadowRay
//   tMin, tMax  the interval to search, scene units; an empty interval costs nothing and returns 1
//   threshold   radius of the cone where it starts, scene units, > 0
//   spread      how fast the cone widens, per scene unit: the tangent of the lamp's angular radius
//   formula     max((s - 0.2) / 0.8, 0), where s is the smallest of 1 and distance / (threshold + spread t)
//               over the steps; once s has fallen to 1/5, the share is 0 and the march ends
// The march needs a lower bound of the distance. The values in between are a model and measure no area.
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
