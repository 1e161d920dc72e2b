// An overshoot at the wall of a cell: drag the ray along a fence of slanting planks. If only the copy in the point's
// cell is evaluated, a circle may reach into the plank behind the wall, and the march may step through that plank. With
// asked = 1, the nearer neighbour is evaluated too. With asked = 2, every other cell is mirrored, which makes a
// different fence.
#include "figure.glsl"
#include "repetition.glsl"

uniform vec2 eye;   // (-0.9, -0.3) handle: where the ray starts
uniform vec2 aim;   // (0.5, -0.07) handle: where the ray points
uniform int  asked; // 0 in [0, 2]: 0 only the cell's plank, 1 also the nearer neighbour's, 2 mirrored cells

const float PERIOD = 0.75; // width of a cell

// A plank turned by 30 degrees.
//   x  along the fence, from the plank's centre
float plankDistance(float x, float y)
{
    const float c = 0.8660254, s = 0.5;
    return sdRectangle(vec2(c * x + s * y, c * y - s * x), vec2(0.36, 0.06));
}

// The distance that the march uses or, if exact is true, the exact distance.
float fenceDistance(vec2 p, bool exact)
{
    float own = plankDistance(asked == 2 ? opRepeatMirrored(p.x, PERIOD) : opRepeat(p.x, PERIOD), p.y);
    float next = plankDistance(p.x - PERIOD * cellNeighbour(p.x, PERIOD), p.y);
    return asked == 1 || (exact && asked == 0) ? min(own, next) : own;
}

float sceneDistance(vec3 p)
{
    return fenceDistance(p.xy, false);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);
    float t, wall = PERIOD * (cellOf(p.x + 0.5 * PERIOD, PERIOD) - 0.5), fence = fenceDistance(p, true);
    contours(sceneDistance(vec3(p, 0.0)), 0.1, 0.8, PALE);
    fill(fence, SAND, 1.0);
    dashes(p, eye, eye + 6.0 * direction, 1.0, INK);
    int steps = drawMarch(p, eye, direction, 2.2, 0.002, 64, t);
    stroke(fence, 2.5, ORANGE);
    dashes(p, vec2(wall, -1.0), vec2(wall, 1.0), 1.0, INK);
    dot2(p, eye, 7.0, INK);
    number(p, vec2(-1.6, 0.88), float(steps), 0, INK); // # step(s)
    return sheetColour;
}
