// The sign at a corner: drag the tip of the triangle and the point. In the orange region the tip is the nearest point,
// and the normal of one edge says inside although the region is outside. The teal arrow is the sum of both normals.
#include "figure.glsl"

uniform vec2 tip;   // (0.35, 0.1) handle: the corner of the triangle
uniform vec2 point; // (0.75, 0.62) handle: the point whose side we want to find

const vec2 LOW = vec2(-1.3, -0.55), HIGH = vec2(-1.3, 0.35); // the other corners

float sceneDistance(vec3 p)
{
    return sdTriangle(p.xy, LOW, tip, HIGH);
}

// The normal of the edge from a to b, with the triangle on its left.
vec2 edgeNormal(vec2 a, vec2 b)
{
    return normalize(vec2(b.y - a.y, a.x - b.x) + 1e-9);
}

// Whether the tip is the point nearest to p on both edges that meet at the tip.
bool nearTip(vec2 p)
{
    return dot(p - tip, LOW - tip) <= 0.0 && dot(p - tip, HIGH - tip) <= 0.0;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), first = edgeNormal(LOW, tip), second = edgeNormal(tip, HIGH), away = p - tip;
    bool wrong = nearTip(p) && min(dot(away, first), dot(away, second)) < 0.0;
    fill(nearTip(p) ? -1.0 : 1.0, SKY, 0.4);
    fill(wrong ? -1.0 : 1.0, ORANGE, 0.45);
    float d = sceneDistance(vec3(p, 0.0));
    fill(d, SAND, 1.0);
    stroke(d, 2.0, INK);
    dashes(p, tip, point, 1.4, nearTip(point) ? INK : PALE);
    arrow(p, tip, tip + 0.45 * first, 2.0, dot(point - tip, first) < 0.0 ? ORANGE : BLUE);
    arrow(p, tip, tip + 0.45 * second, 2.0, dot(point - tip, second) < 0.0 ? ORANGE : BLUE);
    arrow(p, tip, tip + 0.45 * (first + second), 3.0, TEAL);
    dot2(p, point, 4.0, INK);
    number(p, vec2(-1.58, 0.86), dot(point - tip, first), 2, BLUE); // first edge #
    number(p, vec2(-1.58, 0.74), dot(point - tip, second), 2, BLUE); // second edge #
    number(p, vec2(-1.58, 0.62), dot(point - tip, first + second), 2, TEAL); // sum #
    return sheetColour;
}
