// thickness.glsl - how much of a solid lies between a point of its surface and the light, and how much light
// passes through.
#include "march.glsl"

// How far a ray goes inside a solid before it leaves the solid.
//   ray        starts inside: from a little below the surface, towards the lamp
//   far        how far to search, scene units: to the lamp
//   threshold  depth below which the surface counts as reached, scene units, > 0
//   maxSteps   of this march
//   returns    length of the path inside, scene units, at most far; 0 if the ray starts outside
//   formula    t_0 = 0, t_(n+1) = t_n - distance at t_n, until the distance is at least -threshold
// Inside, the distance must be negative and its magnitude a lower bound of the depth, so that the march steps over no
// exit. A union with min and a smooth union satisfy this, although the steps inside them are short.
float thicknessAlong(Ray ray, float far, float threshold, int maxSteps)
{
    traceBegin(0.0, far);
    float t = 0.0;
    int steps = 0;
    bool inside = true;
    while (inside) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        t += max(-distance, 0.0);
        inside = distance < -threshold && t < far && steps < maxSteps;
    }
    return min(t, far);
}

// The share of the light that remains after a straight path through a solid.
//   way      length of the path, >= 0, scene units
//   depth    the length after which 1 / e = 0.37 remains, > 0 per channel, scene units
//   formula  exp(-way / depth)
// Source: P. Bouguer (1729), J. H. Lambert (1760), A. Beer (1852).
vec3 lightThrough(float way, vec3 depth)
{
    return exp(-way / depth);
}
