#version 330 core
// For rays.c: the library's march, box interval, shadow ray and normal along random rays.
//
// Each item takes 4 pixels of a row: (origin, -), (direction, -), and two pixels of results. Time selects the function;
// iMouse contains its arguments.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "random.glsl"
#include "primitives.glsl"
#include "march.glsl"
#include "normal.glsl"
#include "shadow.glsl"
#include "bounds.glsl"

const vec3 HALF = vec3(0.75, 0.5, 1.25);

// The scene, from the last digit of Time: 0 is a ball, 1 a plane, 2 a box, and 3 an empty scene with a distance of 1.
float sceneDistance(vec3 p)
{
    int which = int(Time) % 10;
    if (which == 0)
        return sdSphere(p, 1.0);
    if (which == 1)
        return sdPlane(p, vec3(0.0, 1.0, 0.0), 0.0);
    return which == 2 ? sdBox(p, HALF) : 1.0;
}

// Not used here, but the library declares this function.
Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0));
}

// A ray from a random point in a cube to a random point near the centre. Every fourth direction is perpendicular to one
// axis or two.
Ray randomRay(int item)
{
    vec3 origin = 4.0 * nextVector();
    vec3 direction = 1.5 * nextVector() - origin;
    if (item % 4 == 3)
        direction[(item / 4) % 3] = 0.0;
    if (item % 8 == 7)
        direction[(item / 4 + 1) % 3] = 0.0;
    if (item % 16 == 5)
        origin *= 0.125;
    if (item % 10 == 1)
        origin.y = abs(origin.y);
    return Ray(origin, direction / max(length(direction), 0.001));
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 4 + 256 * pixel.y;
    int slot = pixel.x % 4;
    seed = uint(item) * 9781u + 17u;
    traceReset(-1);
    Ray ray = randomRay(item);
    vec4 first = vec4(0.0), second = vec4(0.0);
    if (Time < 10.0) {
        // iMouse: far limit, threshold, maximum number of steps, start
        Hit hit = march(ray, iMouse.w, iMouse.x, iMouse.y, int(iMouse.z));
        first = vec4(hit.t, hit.found, trace.end, trace.evaluations);
        second = vec4(trace.steps, trace.allSteps, trace.marches, trace.t);
    } else if (Time < 20.0) {
        first.xy = boxInterval(ray, -HALF, HALF);
    } else if (Time < 30.0) {
        // A point of the ball in the direction of the ray, or a point in the upper face of the box; iMouse.x: step
        vec3 p = int(Time) == 20 ? ray.direction : vec3(0.7, 0.5, 1.2) * vec3(nextSigned(), 1.0, nextSigned());
        first = vec4(p, trace.evaluations);
        second = vec4(normalAt(p, iMouse.x), trace.evaluations);
    } else {
        // iMouse: far limit, threshold, maximum number of steps, offset
        Ray up = shadowRay(ray.origin, vec3(0.0, 1.0, 0.0), ray.direction, iMouse.w);
        float reaching = lightReaching(up, iMouse.x, iMouse.y, int(iMouse.z));
        first = vec4(up.origin, reaching);
        second = vec4(up.direction, trace.allSteps);
    }
    FragColor = slot == 0 ? vec4(ray.origin, 0.0) : (slot == 1 ? vec4(ray.direction, 0.0) : (slot == 2 ? first : second));
}
