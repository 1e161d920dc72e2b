// Two shapes become one: drag the disc, the block and the point. The radius of the circle around the point is the value
// of the formula, which is shown at the top left. The circle never crosses the surface. Where it touches the surface,
// the formula is exact; where it leaves a gap, the formula is a lower bound.
#include "figure.glsl"

uniform int  operation; // 1 in [0, 2]: 0 union, 1 intersection, 2 block minus disc
uniform vec2 disc;      // (0.3, -0.15) handle units: centre of the disc
uniform vec2 block;     // (-0.65, -0.15) handle units: centre of the block
uniform vec2 point;     // (0.02, 0.58) handle units: where the formula is evaluated

const vec2 HALF_SIZE = vec2(0.6, 0.5); // half the width and height of the block

float sceneDistance(vec3 p)
{
    float a = sdRectangle(p.xy - block, HALF_SIZE), b = sdCircle(p.xy - disc, 0.5);
    if (operation == 0)
        return opUnion(a, b);
    return operation == 1 ? opIntersection(a, b) : opSubtraction(a, b);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0)), empty = sceneDistance(vec3(point, 0.0));
    fill(d, SAND, 1.0);
    contours(d, 0.1, 0.8, PALE);
    fill(length(p - point) - abs(empty), SKY, 0.7);
    stroke(sdRectangle(p - block, HALF_SIZE), 1.0, INK);
    stroke(sdCircle(p - disc, 0.5), 1.0, INK);
    stroke(d, 3.0, ORANGE);
    stroke(length(p - point) - abs(empty), 1.5, BLUE);
    dot2(p, point, 7.0, INK);
    number(p, vec2(-1.6, 0.88), empty, 2, BLUE); // formula #
    return sheetColour;
}
