// cone.glsl - sphere tracing with a cone in place of a line: what is smaller than a pixel counts as
// reached.
#include "camera.glsl"
#include "march.glsl"

// How fast a pixel's ray widens: half the side of a pixel, seen from the eye, per scene unit along
// the view direction.
//   formula  1 / (iResolution.y focalLength): the screen is 2 high, focalLength before the eye
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
    trace.marches++;
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
