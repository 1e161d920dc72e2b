#version 330 core
// For limits.c: marches far from the origin, towards sheets without thickness. Time selects the sheet; iMouse contains
// the x coordinate of its middle, the threshold in multiples of the proved one, the index of the first case, and 0. A
// pixel's x is the index of the case, and its y selects the results.

in float Time;
out vec4 FragColor;

#include "cone.glsl"
#include "primitives.glsl"
#include "repetition.glsl"

const float UNIT = 5.9604644775390625e-8; // the largest relative error of one rounding
const float SIZE = 1.2;                   // no point of a sheet is farther than this from its middle

int number;
vec3 middle;

// The value, computed so that no compiler can combine it with other terms.
vec3 opaque(vec3 v)
{
    return uintBitsToFloat(floatBitsToUint(v) ^ uvec3(iMouse.w));
}

float sceneDistance(vec3 p)
{
    vec3 q = p - middle;
    return abs(int(Time) == 0 ? sdSphere(q, 1.0) : sdBox(q, vec3(0.7, 0.5, 0.6)));
}

vec3 lot(int dimension)
{
    return 2.0 * vec3(cellRandom(ivec3(number, dimension, 0)), cellRandom(ivec3(number, dimension, 1)),
                      cellRandom(ivec3(number, dimension, 2))) - 1.0;
}

void main()
{
    number = int(iMouse.z) + int(gl_FragCoord.x);
    int row = int(gl_FragCoord.y);
    traceReset(-1);
    middle = opaque(iMouse.x * vec3(1.0, 0.37, -0.61));
    vec3 side = normalize(lot(0) + 0.001), start = middle + 4.0 * side;
    Ray ray = Ray(opaque(start), opaque(normalize(0.9 * lot(1) - 4.0 * side)));
    // r(t) = u (2 |o| + 14 t + 24 s)
    float first = iMouse.y * UNIT * (2.0 * length(ray.origin) + 24.0 * SIZE), spread = iMouse.y * UNIT * 14.0;
    Hit hit = marchCone(ray, 0.0, 8.0, first, spread, 1000);
    float t = 8.0 * lot(2).x * lot(2).x;
    float distance = sceneDistance(ray.origin + t * ray.direction);
    FragColor = row == 0 ? vec4(ray.origin, hit.t) : row == 1 ? vec4(ray.direction, hit.found) : vec4(t, distance, first, 0.0);
}
