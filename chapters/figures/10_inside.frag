// Inside or outside: drag the point, and the corner at the mouth of the spiral. The half-line from the point to the
// right crosses the outline; if the number of crossings, written at the point, is odd, the point is inside. The
// number at a corner says how many sides count when the half-line passes through the corner: those that have their
// lower end there.
#include "figure.glsl"

uniform vec2 point;  // (-0.62, -0.25) handle units: the point that is tested
uniform vec2 corner; // (-1.28, -0.56) handle units: a corner of the figure

const int COUNT = 16;
const vec2 SPIRAL[POLYGON_CORNERS] = vec2[POLYGON_CORNERS](
    vec2(-1.3, -0.8), vec2(1.25, -0.86), vec2(1.32, 0.76), vec2(-1.1, 0.85), vec2(-1.15, -0.34), vec2(0.66, -0.4),
    vec2(0.7, 0.3), vec2(-0.5, 0.36), vec2(-0.52, 0.1), vec2(0.4, 0.05), vec2(0.38, -0.15), vec2(-0.85, -0.1),
    vec2(-0.8, 0.6), vec2(1.02, 0.5), vec2(0.95, -0.62), vec2(-1.28, -0.56));

float spiralDistance(vec2 p)
{
    vec2 at[POLYGON_CORNERS] = SPIRAL;
    at[COUNT - 1] = corner;
    return sdPolygon(p, at, COUNT);
}

float sceneDistance(vec3 p)
{
    return spiralDistance(p.xy);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), at[POLYGON_CORNERS] = SPIRAL;
    at[COUNT - 1] = corner;
    float d = spiralDistance(p);
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    if (abs(p.y - point.y) < penWidth(2.5) && spiralDistance(vec2(p.x, point.y)) < 0.0) // inside, on the half-line
        line2(p, point, vec2(4.0, point.y), 2.5, INK);
    dashes(p, point, vec2(4.0, point.y), 1.5, INK);

    // Count the sides that span the height of the point and that the half-line meets.
    int crossings = 0;
    float counted = 0.0;
    vec2 label = vec2(9.0);
    vec2 from = at[COUNT - 1], before = at[COUNT - 2];
    for (int i = 0; i < COUNT; i++) {
        vec2 to = at[i];
        bool begins = from.y <= point.y, ends = to.y <= point.y; // is this end at most as high as the point?
        float x = from.x + (to.x - from.x) * (point.y - from.y) / (to.y - from.y + (begins != ends ? 0.0 : 1.0));
        if (begins != ends && x > point.x) {
            crossings++;
            dot2(p, vec2(x, point.y), 8.0, TEAL);
        }
        vec2 beside = from + 0.09 * normalize(from - 0.5 * (before + to) + 1e-6);
        if (length(p - beside) < length(p - label)) { // this pixel shows the number of the nearest corner
            label = beside;
            counted = float(before.y > from.y) + float(to.y > from.y);
        }
        before = from;
        from = to;
    }
    bool inside = crossings % 2 == 1;
    number(p, label, counted, 0, INK);
    dot2(p, point, 9.0, inside ? ORANGE : BLUE);
    number(p, point + vec2(0.0, 0.1), float(crossings), 0, inside ? ORANGE : BLUE); // # crossing(s)
    return sheetColour;
}
