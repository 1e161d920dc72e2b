// Towers that differ, seen from above: drag the ray's start and its aim. In each cell, only the tower of that cell is
// evaluated. If the parameter `capped` is on, a circle never reaches the tower of another cell; if it is off, the ray
// passes through towers. The number of steps is at the top left.
#include "figure.glsl"
#include "repetition.glsl" // cellOf, cellRandom

uniform vec2 eye;    // (-0.175, 0.335) handle units: where the ray starts
uniform vec2 aim;    // (0.509, -0.080) handle units: where the ray points
uniform bool capped; // true: no step is longer than the distance to the next cell's towers

const float PERIOD = 0.7, GAP = 0.09; // the side of a cell, and half of the narrowest street, units

vec2 inCell(vec2 p)
{
    return p - PERIOD * vec2(cellOf(p.x, PERIOD), cellOf(p.y, PERIOD));
}

float towerDistance(vec2 p)
{
    float random = cellRandom(ivec3(cellOf(p.x, PERIOD), cellOf(p.y, PERIOD), 10));
    return sdRectangle(inCell(p), mix(vec2(0.025), vec2(0.5 * PERIOD - GAP), fract(random * vec2(1.0, 256.0))));
}

float sceneDistance(vec3 p)
{
    vec2 q = abs(inCell(p.xy));
    float wall = 0.5 * PERIOD - max(q.x, q.y); // distance to the nearest border of the cell
    return capped ? min(towerDistance(p.xy), wall + GAP) : towerDistance(p.xy);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6), q = abs(inCell(p));
    float d = towerDistance(p), t;
    stroke(0.5 * PERIOD - max(q.x, q.y), 1.0, mix(PALE, PAPER, 0.4));
    dashes(p, eye, eye + 4.0 * direction, 1.0, PALE);
    fill(d, SAND, 1.0);
    int steps = drawMarch(p, eye, direction, 4.0, 0.003, 64, t);
    stroke(d, 2.0, ORANGE);
    dot2(p, vec2(-1.66, 0.9), 26.0, PAPER);
    number(p, vec2(-1.66, 0.9), float(steps), 0, BLUE); // # step(s)
    return sheetColour;
}
