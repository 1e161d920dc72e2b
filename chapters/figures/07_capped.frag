// Copies that differ: drag the point. The radius of the blue circle is the distance to the copy in the point's cell;
// this circle may reach into a neighbouring copy. The radius of the green circle is capped, so this circle stays empty:
// no copy leaves its pale square, whose half width is `reach`. Below are both distances along the dashed line, at twice
// the scale.
#include "figure.glsl"
#include "repetition.glsl"

uniform vec2  point; // (0.36, 0.06) handle: where the distance is evaluated
uniform float reach; // 0.24 in [0.2, 0.32] step 0.01, units: how far a copy may reach from the centre of its cell

const float PERIOD = 0.66;
const float EDGE = 2.5 * PERIOD;          // right edge of the field, which has 5 x 2 cells
const float BOTTOM = -0.35, GROUND = -0.93; // lower edge of the field, and axis of the graph

// Map a point of the sheet to the field, where cell (0, 0) is in the middle of the lower row.
vec2 fieldPoint(vec2 p)
{
    return p - vec2(0.0, BOTTOM + 0.5 * PERIOD);
}

// The distance to the copy in the cell of q, a square of random size.
float ownDistance(vec2 q)
{
    vec2 cell = vec2(cellOf(q.x, PERIOD), cellOf(q.y, PERIOD));
    return sdRectangle(q - PERIOD * cell, vec2(0.06 + 0.14 * cellRandom(ivec3(cell.x + 7.0, 0, cell.y))));
}

float sceneDistance(vec3 p)
{
    return min(ownDistance(p.xy), min(cellOthers(p.x, PERIOD, reach), cellOthers(p.y, PERIOD, reach)));
}

void field(vec2 q, vec2 at)
{
    vec2 inCell = vec2(opRepeat(q.x, PERIOD), opRepeat(q.y, PERIOD));
    float d = ownDistance(q);
    stroke(0.5 * PERIOD - max(abs(inCell.x), abs(inCell.y)), 1.5, INK);
    stroke(sdRectangle(inCell, vec2(reach)), 1.0, PALE);
    fill(length(q - at) - abs(ownDistance(at)), SKY, 0.7);
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    dashes(q, vec2(-EDGE, at.y), vec2(EDGE, at.y), 1.0, PALE);
    stroke(length(q - at) - abs(ownDistance(at)), 1.5, BLUE);
    stroke(length(q - at) - abs(sceneDistance(vec3(at, 0.0))), 1.8, TEAL);
    dot2(q, at, 8.0, INK);
}

void graph(vec2 p, vec2 q, vec2 at)
{
    stroke(0.5 * PERIOD - abs(opRepeat(q.x, PERIOD)), 1.0, PALE);
    stroke(p.y - GROUND, 1.2, INK);
    curve(p.y - GROUND - 2.0 * ownDistance(vec2(q.x, at.y)), 1.5, 1.5, BLUE);
    curve(p.y - GROUND - 2.0 * sceneDistance(vec3(q.x, at.y, 0.0)), 1.5, 2.0, TEAL);
    dot2(p, vec2(at.x, GROUND + 2.0 * ownDistance(at)), 7.0, BLUE);
    dot2(p, vec2(at.x, GROUND + 2.0 * sceneDistance(vec3(at, 0.0))), 7.0, TEAL);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), q = fieldPoint(p);
    vec2 at = fieldPoint(clamp(point, vec2(-EDGE, BOTTOM), vec2(EDGE, BOTTOM + 2.0 * PERIOD) - 0.001));
    if (abs(p.x) > EDGE + 0.004)
        return sheetColour;
    if (p.y > BOTTOM - 0.004)
        field(q, at);
    else if (p.y < BOTTOM - 0.03)
        graph(p, q, at);
    return sheetColour;
}
