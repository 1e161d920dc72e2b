#version 330 core
// For solids.c and swept.c: extrusions, revolutions and the solids of shaders/solids.glsl, at random points. Each item
// takes 2 pixels of a row: a point with its distance, and another point, near or far, with its distance. Time selects
// the function; iMouse contains its arguments.

in float Time;
out vec4 FragColor;

#include "random.glsl"
#include "solids.glsl"
#include "transform.glsl"

uniform vec4 iMouse;

// A disc of radius 1 whose centre is iMouse.x from the axis.
float disc(vec2 q)
{
    return sdCircle(q - vec2(iMouse.x, 0.0), 1.0);
}

// A rectangle with the half sides iMouse.xy, rotated by iMouse.z.
float rectangle(vec2 q)
{
    float c = cos(iMouse.z), s = sin(iMouse.z);
    return sdRectangle(vec2(c * q.x + s * q.y, c * q.y - s * q.x), iMouse.xy);
}

// An L of two rectangles, whose inner corner is at the origin.
float elbow(vec2 q)
{
    float foot = sdRectangle(q - vec2(0.3, -0.15), vec2(0.6, 0.15));
    return min(foot, sdRectangle(q - vec2(-0.15, 0.3), vec2(0.15, 0.6)));
}

// A bowl: a polyline from the axis outwards and upwards, thickened by iMouse.x on both sides.
float bowl(vec2 q)
{
    float floorLine = sdSegment(q, vec2(0.0, -0.7), vec2(0.4, -0.7));
    float wall = min(sdSegment(q, vec2(0.4, -0.7), vec2(0.9, 0.1)), sdSegment(q, vec2(0.9, 0.1), vec2(0.6, 0.7)));
    return min(floorLine, wall) - iMouse.x;
}

// A square of half side 0.5, extruded, rotated by iMouse.x and shrunk by iMouse.y per unit of height from 0 to 2.
float twisted(vec3 p)
{
    float y = clamp(p.y, 0.0, 2.0), size = 1.0 - iMouse.y * y;
    float c = cos(iMouse.x * y), s = sin(iMouse.x * y);
    vec2 q = vec2(c * p.x + s * p.z, c * p.z - s * p.x) / size;
    return size * sdRectangle(q, vec2(0.5));
}

float asked(vec3 p)
{
    switch (int(Time)) {
    case 0: return sdCylinder(p, iMouse.x, iMouse.y);
    case 1: return sdHexPrism(p, iMouse.x, iMouse.y);
    case 2: return sdCappedCone(p, iMouse.x, iMouse.y, iMouse.z);
    case 3: return sdCapsule(p, vec3(-0.5, -0.3, 0.2), vec3(0.4, 0.6, -0.1), iMouse.x);
    case 4: return opExtrude(opOnion(sdCircle(p.xz, iMouse.x), iMouse.y), p.y, iMouse.z);
    case 5: return opExtrude(elbow(p.xz), p.y, iMouse.x);
    case 6: return disc(opRevolve(p, 0.0));
    case 7: return rectangle(opRevolve(p, iMouse.w));
    case 8: return bowl(opRevolve(p, 0.0));
    case 9: return sdCircle(opRevolve(p, iMouse.x), iMouse.y);
    case 10: return sdTorus(p, iMouse.x, iMouse.y);
    case 11: return twisted(p);
    default: return 0.0;
    }
}

// Of every eight points, five are in a cube around the solid, one is far away, one near the axis, and one on the axis.
// The first point for a disc is on the axis, at the height iMouse.z.
vec3 point(int item)
{
    if (item == 0 && int(Time) == 6)
        return vec3(0.0, iMouse.z, 0.0);
    vec3 p = 1.8 * nextVector();
    int kind = item % 8;
    if (kind == 5)
        p *= 64.0;
    if (kind == 6)
        p.xz *= 0.01;
    if (kind == 7)
        p.xz = vec2(0.0);
    return p;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 2 + 256 * pixel.y;
    seed = uint(item) * 9781u + 17u;
    vec3 p = point(item);
    vec3 q = p + exp2(-16.0 * abs(nextSigned())) * nextVector();
    p = pixel.x % 2 == 0 ? p : q;
    FragColor = vec4(p, asked(p));
}
