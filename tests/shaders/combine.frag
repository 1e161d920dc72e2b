#version 330 core
// For combine.c: combinations of two equal balls at random points, each with a second point near it.
//
// Each item takes 4 pixels of a row: (p, f(p)), (q, f(q)), (a, b, the share of b, -), and the smooth union at
// (a + h, b), (a - h, b), (a, b + h), (a, b - h). Time is the operation; iMouse contains half the distance between the
// centres, the width of the blend, h, and the radius.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "random.glsl"
#include "primitives.glsl"
#include "combine.glsl"

float left(vec3 p)
{
    return sdSphere(p + vec3(iMouse.x, 0.0, 0.0), iMouse.w);
}

float right(vec3 p)
{
    return sdSphere(p - vec3(iMouse.x, 0.0, 0.0), iMouse.w);
}

// The cubic smooth union, or the quadratic one if Time is 4.
float blended(float a, float b)
{
    return int(Time) == 4 ? opSmoothUnionQuadratic(a, b, iMouse.y) : opSmoothUnion(a, b, iMouse.y);
}

float asked(vec3 p)
{
    float a = left(p), b = right(p);
    int which = int(Time);
    if (which == 0)
        return opUnion(a, b);
    if (which == 1)
        return opIntersection(a, b);
    if (which == 2)
        return opSubtraction(a, b);
    return blended(a, b);
}

// A quarter of the points are in the plane where a = b, and another quarter in a box of half the size.
vec3 point(int item)
{
    vec3 p = 2.0 * nextVector();
    if (item % 4 == 3)
        p.x = 0.0;
    return item % 4 == 2 ? 0.5 * p : p;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 4 + 256 * pixel.y;
    int slot = pixel.x % 4;
    seed = uint(item) * 9781u + 17u;
    vec3 p = point(item);
    vec3 q = p + exp2(-12.0 * abs(nextSigned())) * nextVector();
    float a = left(p), b = right(p), k = iMouse.y, h = iMouse.z;
    float share = int(Time) == 4 ? smoothUnionQuadraticShare(a, b, k) : smoothUnionShare(a, b, k);
    vec4 shares = vec4(a, b, share, 0.0);
    vec4 moved = vec4(blended(a + h, b), blended(a - h, b), blended(a, b + h), blended(a, b - h));
    FragColor = slot == 0 ? vec4(p, asked(p)) : (slot == 1 ? vec4(q, asked(q)) : (slot == 2 ? shares : moved));
}
