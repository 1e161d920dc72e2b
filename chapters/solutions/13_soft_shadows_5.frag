// Solution to exercise 13.5: the march continues inside the objects. There, distance / t is
// negative and shows how far the ray is behind the edge. One closed form covers both sides.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour

// The smallest distance / t, from spread down to about -spread. With steps of at least a fiftieth
// of t, the march passes through the objects that it meets.
float signedClearance(Ray ray, float far)
{
    float t = hitThreshold, smallest = spread;
    int steps = 0;
    bool searching = t < far;
    while (searching) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        smallest = min(smallest, distance / t);
        t += max(distance, 0.01 + 0.02 * t);
        steps++;
        searching = smallest > -spread && t < far && steps < 2 * maxSteps;
    }
    return smallest;
}

vec3 rayColour(Ray ray)
{
    vec3 toSun = sunDirection();
    Surface surface = surfaceAt(ray);
    Ray there = sunRay(surface, toSun);
    float seen = discBesideEdge(signedClearance(there, sunReach(surface, there)) / spread);
    return encodeSRGB(surfaceLight(surface, ray, toSun, seen));
}
