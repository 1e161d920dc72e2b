#version 330 core
// For plane.c: the figures of plane.glsl and the results of operations on them, at random points. Each item takes 2
// pixels of a row: a point with its distance, and another point, near or far, with its distance. Time selects the
// function. The first point of every fourth item is on a lattice with a spacing of 1/16, which contains the corners of
// the figures.

in float Time;
out vec4 FragColor;

#include "random.glsl"
#include "plane.glsl"
#include "combine.glsl"

const vec2 O = vec2(0.0);
const vec2 DART[16] = vec2[16](vec2(-0.875, 0.125), vec2(0.6875, 0.8125), vec2(0.1875, 0.0), vec2(0.625, -0.8125),
                               O, O, O, O, O, O, O, O, O, O, O, O);
const vec2 STAR[16] = vec2[16](
    vec2(0.0, 0.875), vec2(0.125, 0.375), vec2(0.625, 0.625), vec2(0.375, 0.125), vec2(0.875, 0.0), vec2(0.375, -0.125),
    vec2(0.625, -0.625), vec2(0.125, -0.375), vec2(0.0, -0.875), vec2(-0.125, -0.375), vec2(-0.625, -0.625),
    vec2(-0.375, -0.125), vec2(-0.875, 0.0), vec2(-0.375, 0.125), vec2(-0.625, 0.625), vec2(-0.125, 0.375));
const vec2 CROSSED[16] = vec2[16](vec2(0.0, 0.875), vec2(0.5, -0.75), vec2(-0.875, 0.25), vec2(0.875, 0.25),
                                  vec2(-0.5, -0.75), O, O, O, O, O, O, O, O, O, O, O);

float asked(vec2 p)
{
    const vec2 a = vec2(-0.875, -0.5), b = vec2(0.75, -0.625), c = vec2(-0.25, 0.75);
    float box = sdRectangle(p, vec2(0.75, 0.5));
    float disc = sdCircle(p - vec2(0.75, 0.25), 0.5);
    switch (int(Time)) {
    case 0: return sdCircle(p, 0.75);
    case 1: return sdSegment(p, a, c);
    case 2: return box;
    case 3: return sdTriangle(p, a, b, c);
    case 4: return sdTriangle(p, a, c, b);
    case 5: return sdPolygon(p, DART, 4);
    case 6: return sdPolygon(p, STAR, 16);
    case 7: return sdPolygon(p, CROSSED, 5);
    case 8: return sdArc(p, 0.75, 2.0);
    case 9: return sdArc(p, 0.75, 0.5);
    case 10: return opRound(sdRectangle(p, vec2(0.5, 0.25)), 0.25);
    case 11: return opRound(sdPolygon(p, DART, 4), 0.125);
    case 12: return opOnion(box, 0.125);
    case 13: return opUnion(box, disc);
    case 14: return opIntersection(box, disc);
    case 15: return opSubtraction(box, disc);
    case 16: return opSmoothUnion(box, disc, 0.25);
    }
    return mix(sdCircle(p + vec2(0.5, 0.0), 0.625), sdCircle(p - vec2(0.5, 0.0), 0.625), 0.5);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 2 + 256 * pixel.y;
    seed = uint(item) * 9781u + 17u;
    vec2 p = 1.75 * nextVector().xy;
    if (item % 4 == 3)
        p = floor(16.0 * p + 0.5) / 16.0;
    vec2 q = p + exp2(-12.0 * abs(nextSigned())) * nextVector().xy;
    FragColor = pixel.x % 2 == 0 ? vec4(p, asked(p), 0.0) : vec4(q, asked(q), 0.0);
}
