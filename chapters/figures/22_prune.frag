// Which parts matter in a cell: drag the cell. The circle through its corners has the radius r. A part that is farther
// from the centre than the nearest part by more than the blend plus 2 r cannot change the distance anywhere in the
// circle, and is drawn pale. The other parts are in the list; the number at the top left counts them.
#include "figure.glsl"

uniform vec2  cell;  // (-0.35, 0.15) handle: the centre of the cell
uniform float side;  // 0.3 in [0.05, 1] step 0.05: side of the cell
uniform float blend; // 0.12 in [0.01, 0.5] step 0.01: width of the blend

const int COUNT = 14;

// Part i, a ball: its centre (xy) and radius (z).
vec3 ball(int i)
{
    float a = 2.399963 * float(i), far = 0.28 * sqrt(float(i) + 0.5);
    return vec3(1.35 * far * cos(a) , 0.8 * far * sin(a) - 0.05, 0.11 + 0.05 * sin(5.0 * a));
}

float ballDistance(int i, vec2 p)
{
    vec3 b = ball(i);
    return length(p - b.xy) - b.z;
}

float sceneDistance(vec3 p)
{
    float d = 1e6;
    for (int i = 0; i < COUNT; i++)
        d = opSmoothUnion(d, ballDistance(i, p.xy), blend);
    return d;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float r = 0.5 * sqrt(2.0) * side, least = 1e6;
    for (int i = 0; i < COUNT; i++)
        least = min(least, ballDistance(i, cell));
    int kept = 0;
    for (int i = 0; i < COUNT; i++) {
        float d = ballDistance(i, p);
        bool matters = ballDistance(i, cell) <= least + blend + 2.0 * r;
        kept += int(matters);
        fill(d, matters ? SAND : mix(PAPER, PALE, 0.3), 1.0);
        stroke(d, 1.2, matters ? ORANGE : PALE);
    }
    stroke(sceneDistance(vec3(p, 0.0)), 2.5, INK);
    vec2 q = abs(p - cell) - 0.5 * side;
    fill(max(q.x, q.y), SKY, 0.6);
    stroke(max(q.x, q.y), 2.0, BLUE);
    stroke(length(p - cell) - r, 1.0, BLUE);
    dot2(p, cell, 7.0, BLUE);
    number(p, vec2(-1.6, 0.88), float(kept), 0, ORANGE); // # in the list
    return sheetColour;
}
