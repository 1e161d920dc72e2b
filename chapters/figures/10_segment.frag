// The nearest point of a segment: drag the point and both ends. The circle around the point is empty and touches the
// segment. The blue number is the distance. The green number is the fraction of the line from a to b at which the
// perpendicular from the point meets it; below 0 or above 1 the foot of the perpendicular is outside the segment, and
// an end is nearest.
#include "figure.glsl"

uniform vec2 point; // (0.12, 0.28) handle units: the point whose distance is measured
uniform vec2 a;     // (-0.95, -0.5) handle units: where the segment begins
uniform vec2 b;     // (0.85, -0.2) handle units: where the segment ends

float sceneDistance(vec3 p)
{
    return sdSegment(p.xy, a, b + 1e-6);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), way = b - a + 1e-6, square = 4.0 * vec2(-way.y, way.x) / length(way);
    float share = dot(point - a, way) / dot(way, way), d = sceneDistance(vec3(point, 0.0));
    vec2 foot = a + share * way, nearest = a + clamp(share, 0.0, 1.0) * way;
    vec2 away = normalize(point - nearest + 1e-6); // from the segment to the point

    // Between the two perpendiculars through the ends, the foot is nearest.
    float along = dot(p - a, way) / dot(way, way);
    fill((abs(along - 0.5) - 0.5) * length(way), SAND, 0.4);
    dashes(p, a - square, a + square, 1.0, PALE);
    dashes(p, b - square, b + square, 1.0, PALE);
    dashes(p, a - 4.0 * normalize(way), b + 4.0 * normalize(way), 1.0, PALE);

    fill(length(p - point) - d, SKY, 0.7);
    stroke(length(p - point) - d, 1.2, BLUE);
    line2(p, a, b, 4.0, ORANGE);
    dashes(p, point, foot, 1.5, TEAL);
    line2(p, point, nearest, 2.0, INK);
    dot2(p, foot, 7.0, TEAL);
    dot2(p, nearest, 7.0, INK);
    dot2(p, point, 7.0, INK);
    number(p, point + 0.11 * away, d, 2, BLUE); // # | distance #
    number(p, foot - 0.11 * away, share, 2, TEAL); // # | fraction #
    return sheetColour;
}
