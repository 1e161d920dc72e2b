// A fold: drag the mirror, the tip of its normal, and the point. The side to which the normal points is kept, and its
// image appears on the other side. If the letter is behind the mirror, it disappears, and only a pale outline is left.
// The radius of the circle is the distance from the end of the blue arrow, the folded point, to the letter.
#include "figure.glsl"
#include "symmetry.glsl"

uniform vec2  mirror;       // (-0.1, 0.0) handle: a point on the mirror
uniform vec2  normal;       // (0.14, 0.1) handle: the tip of the normal
uniform vec2  point;        // (-0.72, 0.42) handle: the point that is folded
uniform float normalLength; // 1 in [0.4, 1.6] step 0.1: the length of the normal in the formula

// The distance to the letter F.
float letterDistance(vec2 p)
{
    vec2 q = p - vec2(0.75, 0.0);
    float stem = sdSegment(q, vec2(-0.2, -0.35), vec2(-0.2, 0.35));
    float top = sdSegment(q, vec2(-0.2, 0.35), vec2(0.25, 0.35));
    return opRound(min(min(stem, top), sdSegment(q, vec2(-0.2, 0.05), vec2(0.1, 0.05))), 0.06);
}

vec2 folded(vec2 p)
{
    vec2 n = normalLength * normalize(normal - mirror + vec2(1e-6, 0.0));
    return opReflect(vec3(p, 0.0), vec3(n, 0.0), -dot(mirror, n)).xy;
}

float sceneDistance(vec3 p)
{
    return letterDistance(folded(p.xy));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), n = normalize(normal - mirror + vec2(1e-6, 0.0)), along = 5.0 * vec2(-n.y, n.x);
    float d = sceneDistance(vec3(p, 0.0)), empty = abs(sceneDistance(vec3(point, 0.0)));
    contours(d, 0.1, 0.8, PALE);
    fill(length(p - point) - empty, SKY, 0.7);
    fill(d, SAND, 1.0);
    stroke(letterDistance(p), 1.2, PALE);
    stroke(d, 2.5, ORANGE);
    line2(p, mirror - along, mirror + along, 2.0, INK);
    arrow(p, mirror, normal, 2.0, INK);
    stroke(length(p - point) - empty, 1.5, BLUE);
    arrow(p, point, folded(point), 1.5, BLUE);
    dot2(p, point, 8.0, BLUE);
    dot2(p, mirror, 7.0, INK);
    return sheetColour;
}
