// One ball, many copies: drag the point, and the ball in the shaded cell. The formula moves the point into this cell,
// to the end of the arrow. The radius of the blue circle is the distance to the copy in the point's cell. The radius of
// the green circle also takes the copy in the nearer neighbouring cell into account, so this circle is always empty.
// The numbers are the two radii.
#include "figure.glsl"
#include "repetition.glsl"

uniform vec2  point;  // (0.5, 0.15) handle: where the distance is evaluated
uniform vec2  ball;   // (0.3, -0.25) handle: centre of the ball in cell 0
uniform float period; // 4 in [2, 6] step 0.25, scene units: width of a cell

const float SCALE = 0.2;  // units of the sheet per scene unit
const float RADIUS = 0.4; // radius of the ball, scene units

// The distance to the copy in a cell, scene units.
float copyDistance(vec2 p, float cell)
{
    vec2 centre = ball / SCALE;
    float room = 0.5 * period - RADIUS; // how far the ball's centre may be from the middle of its cell
    return sdCircle(p - vec2(period * cell + clamp(centre.x, -room, room), centre.y), RADIUS);
}

// The distance to the nearest of all copies.
float sceneDistance(vec3 p)
{
    return min(copyDistance(p.xy, cellOf(p.x, period)), copyDistance(p.xy, cellNeighbour(p.x, period)));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), q = p / SCALE, at = point / SCALE;
    float own = abs(copyDistance(at, cellOf(at.x, period))), nearest = abs(sceneDistance(vec3(at, 0.0)));
    vec2 inCell = vec2(opRepeat(at.x, period), at.y);
    float d = sceneDistance(vec3(q, 0.0)) * SCALE;
    fill((abs(q.x) - 0.5 * period) * SCALE, SKY, 0.45);
    float wall = period * (cellOf(q.x + 0.5 * period, period) - 0.5) * SCALE;
    dashes(p, vec2(wall, -1.0), vec2(wall, 1.0), 1.0, INK);
    fill(length(p - point) - own * SCALE, SKY, 0.7);
    fill(d, SAND, cellOf(q.x, period) == 0.0 ? 1.0 : 0.6);
    stroke(d, cellOf(q.x, period) == 0.0 ? 2.5 : 1.5, ORANGE);
    stroke(length(p - point) - own * SCALE, 1.5, BLUE);
    stroke(length(p - point) - nearest * SCALE, 1.5, TEAL);
    stroke(length(p - inCell * SCALE) - own * SCALE, 1.0, PALE);
    arrow(p, point, inCell * SCALE, 1.5, INK);
    dot2(p, inCell * SCALE, 7.0, BLUE);
    dot2(p, point, 8.0, INK);
    number(p, vec2(-1.6, 0.88), own, 2, BLUE); // own cell #
    number(p, vec2(-1.6, 0.77), nearest, 2, TEAL); // with the neighbour #
    return sheetColour;
}
