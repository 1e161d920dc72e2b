#version 330 core
// For numeric.c: the library's distances at random points, with a second point near each of them.
//
// Each item takes 4 pixels of a row: (p, f(p)), (q, f(q)), and, in each of the last two, the slope of f at p from
// central differences and its length. Time selects the function; iMouse contains the sizes of the solid.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "random.glsl"
#include "primitives.glsl"

const float STEP = 0.0078125; // step of the differences, scene units

float twoBalls(vec3 p)
{
    vec3 shift = vec3(iMouse.x, 0.0, 0.0);
    return min(sdSphere(p + shift, iMouse.w), sdSphere(p - shift, iMouse.w));
}

float asked(vec3 p)
{
    int which = int(Time);
    if (which == 0)
        return sdSphere(p, iMouse.w);
    if (which == 1)
        return sdPlane(p, iMouse.xyz, iMouse.w);
    if (which == 2)
        return sdBox(p, iMouse.xyz);
    if (which == 3)
        return sdBoxFrame(p, iMouse.xyz, iMouse.w);
    return twoBalls(p);
}

// Of every eight points, four are in a cube around the shape, one is far away, one near a corner, one in the plane of a
// face, and one on an axis.
vec3 point(int item)
{
    vec3 p = 2.0 * nextVector();
    int kind = item % 8;
    if (kind == 4)
        p *= 64.0;
    if (kind == 5)
        p = sign(p) * iMouse.xyz + 2.0 * max(iMouse.w, 0.0625) * nextVector();
    if (kind == 6)
        p[(item / 8) % 3] = iMouse[(item / 8) % 3];
    if (kind == 7)
        p = vec3(item / 8 % 3 == 0, item / 8 % 3 == 1, item / 8 % 3 == 2) * p;
    return p;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 4 + 256 * pixel.y;
    seed = uint(item) * 9781u + 17u;
    vec3 p = point(item);
    vec3 q = p + exp2(-16.0 * abs(nextSigned())) * nextVector();
    vec3 slope = vec3(asked(p + vec3(STEP, 0.0, 0.0)) - asked(p - vec3(STEP, 0.0, 0.0)),
                      asked(p + vec3(0.0, STEP, 0.0)) - asked(p - vec3(0.0, STEP, 0.0)),
                      asked(p + vec3(0.0, 0.0, STEP)) - asked(p - vec3(0.0, 0.0, STEP))) / (2.0 * STEP);
    int slot = pixel.x % 4;
    FragColor = slot == 0 ? vec4(p, asked(p)) : (slot == 1 ? vec4(q, asked(q)) : vec4(slope, length(slope)));
}
