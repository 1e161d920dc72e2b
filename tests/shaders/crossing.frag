#version 330 core
// For crossing.c: marches towards random objects, with marchCrossing in the lower row and marchCone in the upper one.
// Time selects the object; x is the index of the case. iMouse contains the threshold, its growth, the distance of the
// point from the ray, and the range of the start.

in float Time;
out vec4 FragColor;

#include "crossing.glsl"
#include "cone.glsl"
#include "repetition.glsl"

int function, number;

float lot(int dimension)
{
    return cellRandom(ivec3(number, 0, dimension));
}

// Object 0 is a point beside the ray, object 1 a wall whose angle with the ray has a sine from 0.05 to 1, object 2 a
// ball, and object 3 a distance that rises linearly on both sides of its minimum.
float sceneDistance(vec3 p)
{
    float middle = 6.0 + 4.0 * lot(0);
    if (function == 0)
        return length(p - vec3(middle, iMouse.z * cos(6.2831853 * lot(1)), iMouse.z * sin(6.2831853 * lot(1))));
    if (function == 1)
        return (0.05 + 0.95 * lot(1)) * (middle - p.x);
    if (function == 2)
        return length(p - vec3(middle, 0.0, 0.98 * lot(1))) - 1.0;
    return (0.05 + 0.95 * lot(1)) * abs(p.x - middle) + 0.06 * (lot(2) - 0.3);
}

void main()
{
    function = int(Time);
    number = int(gl_FragCoord.x);
    traceReset(-1);
    Ray ray = Ray(vec3(0.0), vec3(1.0, 0.0, 0.0));
    float start = iMouse.w * lot(3);
    start = function == 0 ? 6.0 + 4.0 * lot(0) - start : start;
    Hit hit = gl_FragCoord.y > 1.0 ? marchCone(ray, start, 20.0, iMouse.x, iMouse.y, 512)
                                   : marchCrossing(ray, start, 20.0, iMouse.x, iMouse.y, 512);
    bool traced = trace.threshold == iMouse.x && trace.spread == iMouse.y;
    FragColor = vec4(hit.t, hit.found, trace.evaluations, traced ? trace.t : -1.0);
}
