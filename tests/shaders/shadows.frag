// For tests/lib/measure.c: the visible share of the sun in the scene of chapter 13, from one march (red) and from 1024
// rays (blue). Both are 1 where no shadow is computed. The last formula is that of the solution to exercise 13.5.
#include "main.glsl"
#define rayColour chapterRayColour
#include "13_soft_shadows.frag"
#undef rayColour

uniform int formula; // 0 in [0, 4]: hard, smallest distance / t, pairs of steps, pairs twice as hard, continued inside

// As in the solution to exercise 13.5: the smallest distance / t, from -spread to spread. A step is never shorter than
// 0.01 + t / 50, so the march passes through the objects that it meets.
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
    float far = sunReach(surface, there);
    Clearance clearance = clearanceAlong(there, 0.0, far, hitThreshold, maxSteps);
    float inside = discBesideEdge(signedClearance(there, far) / spread);
    float arrived = lampReaching(there, far, spread, 32, hitThreshold, maxSteps, 0);
    float hardness = (formula == 3 ? 2.0 : 1.0) / spread;
    float quick = min(hardness * (formula == 1 ? clearance.most : clearance.least), 1.0);
    float hard = clearance.most > 0.0 ? 1.0 : 0.0;
    return vec3(formula == 4 ? inside : (formula == 0 ? hard : quick), 0.0, arrived);
}
