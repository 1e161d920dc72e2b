// For gloss.c: rays from the upper half of chapter 11's silver ball, which leave it in all directions, and what their
// march meets: red is 1 if it is the silver, green if it is anything else. Time is half the side of the pixel that shows
// the ball, in thousandths of a scene unit.
#include "main.glsl"
#define rayColour chapterRayColour
#include "11_materials.frag"
#undef rayColour
#include "random.glsl"

vec3 rayColour(Ray ray)
{
    seed = uint(int(gl_FragCoord.x) + 1024 * int(gl_FragCoord.y)) * 9781u + 17u;
    vec3 normal = nextDirection(), onward = nextDirection();
    normal.y = abs(normal.y);
    onward *= dot(onward, normal) < 0.0 ? -1.0 : 1.0;
    float halfSide = 0.001 * iTime, radius = hitThreshold + halfSide;
    vec3 p = vec3(-0.45, SILVER_RADIUS, 0.75) + SILVER_RADIUS * normal;
    ray = shadowRay(p, normal, onward, 4.0 * radius);
    vec2 interval = sceneInterval(ray);
    Hit hit = marchCone(ray, interval.x, interval.y, radius, 2.0 * halfSide / SILVER_RADIUS, maxSteps);
    vec3 met = ray.origin + hit.t * ray.direction;
    bool silver = hit.found && silverDistance(met) <= sceneDistance(met);
    return vec3(silver, hit.found && !silver, 0.0);
}
