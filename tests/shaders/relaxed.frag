#version 330 core
// For relaxed.c: marches over random distances, and stretches along a ray. Time selects the function; iMouse contains
// its arguments. A pixel's x is the index of the case, its y the row.

in float Time;
out vec4 FragColor;

#include "relaxed.glsl"
#include "cone.glsl"
#include "repetition.glsl"
#include "stretch.glsl"
#include "transform.glsl"

const int THINGS = 8;

int function, number;

float lot(int thing, int dimension)
{
    return cellRandom(ivec3(number, thing, dimension));
}

// Function 0: the smallest of eight distances that rise linearly along x on both sides of an object; some of the
// objects have a surface, others only come close. Function 1: a point beside the ray. Function 3: a wall in front of
// the ray, or beside it.
float sceneDistance(vec3 p)
{
    if (function == 3)
        return iMouse.x > 0.0 ? iMouse.x : 1.0 - p.x;
    float nearest = 3.0;
    for (int i = 0; i < THINGS; i++) {
        float middle = 12.0 * lot(i, 0);
        float slope = 0.05 + 0.95 * lot(i, 1), least = 0.3 * lot(i, 2) - 0.05;
        float angle = 6.2831853 * lot(i, 3);
        vec3 point = vec3(middle, iMouse.w * vec2(cos(angle), sin(angle)));
        float other = function == 0 ? slope * abs(p.x - middle) + least : length(p - point);
        nearest = min(nearest, i == 0 || function == 0 ? other : nearest);
    }
    return nearest;
}

void main()
{
    function = int(Time);
    number = int(gl_FragCoord.x);
    bool upper = gl_FragCoord.y > 1.0;
    traceReset(-1);
    Ray ray = Ray(vec3(0.0), vec3(1.0, 0.0, 0.0));
    vec3 direction = normalize(vec3(lot(0, 4), lot(0, 5), lot(0, 6)) - 0.5);
    if (function <= 1 || function == 3) {
        // iMouse: threshold (y), omega (z). The upper row is marchCone.
        float far = function == 3 ? 10.0 : 12.0;
        Hit hit = upper ? marchCone(ray, 0.0, far, iMouse.y, 0.001, 512)
                        : marchRelaxed(ray, 0.0, far, iMouse.y, 0.001, iMouse.z, 512);
        FragColor = vec4(hit.t, hit.found, trace.evaluations, trace.end);
    } else {
        float along = upper ? twistStretchAlong(iMouse.x, iMouse.y, direction) : heightStretchAlong(iMouse.x, direction);
        FragColor = vec4(direction, along);
    }
}
