// A march from cell to cell: drag the eye and the aim. A cell with no part nearby has an empty list, and a ray crosses
// it in one step. In the other cells, a step ends at the face of the cell at the latest. At the top left are the number
// of parts that the march evaluates and, in orange, the number for a march that evaluates all parts at every step.
#include "figure.glsl"

uniform vec2  eye;  // (-1.6, 0.45) handle: where the ray starts
uniform vec2  aim;  // (0.6, -0.05) handle: where the ray points
uniform float side; // 0.25 in [0.1, 0.8] step 0.05: side of a cell

const int COUNT = 16;
const float MARGIN = 0.04;

float ballDistance(int i, vec2 p)
{
    float a = 2.399963 * float(i), far = 0.2 * sqrt(float(i) + 0.5);
    return length(p - vec2(0.35 + 1.2 * far * cos(a), -0.25 + 0.8 * far * sin(a))) - 0.06 - 0.03 * sin(7.0 * a);
}

// The smooth union of the parts within reach of a cell, or of all parts: its value, and the number of these parts.
vec2 listAt(vec2 p, vec2 centre, float reach)
{
    vec2 value = vec2(1e6, 0.0);
    for (int i = 0; i < COUNT; i++)
        if (ballDistance(i, centre) < reach)
            value = vec2(opSmoothUnion(value.x, ballDistance(i, p), 0.06), value.y + 1.0);
    return value;
}

float sceneDistance(vec3 p)
{
    return listAt(p.xy, p.xy, 1e5).x;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6), centre = side * (floor(p / side) + 0.5);
    float reach = 0.5 * sqrt(2.0) * side + MARGIN, d = sceneDistance(vec3(p, 0.0));
    if (listAt(p, centre, reach).y > 0.0)
        fill(-1.0, SKY, 0.5);
    vec2 line = abs(p - side * floor(p / side + 0.5));
    fill(min(line.x, line.y) - 0.5 * penWidth(1.0), PALE, 0.5);
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);

    float t = 0.0, spots = 1e6, value = 1.0, parts = 0.0, all = 0.0;
    for (int i = 0; i < 99 && t < 3.6 && value > 0.003; i++) {
        vec2 at = eye + t * direction, low = side * floor(at / side);
        vec2 list = listAt(at, low + 0.5 * side, reach), leave = (low + side * step(0.0, direction) - at) / direction;
        spots = min(spots, length(p - at));
        parts += list.y;
        value = list.x;
        t += value > 0.003 ? min(value, max(min(leave.x, leave.y), 0.0) + 1e-4) : 0.0;
    }
    float s = 0.0;
    for (int i = 0; i < 99 && s < 3.6; i++) {
        float nearest = sceneDistance(vec3(eye + s * direction, 0.0));
        all += float(COUNT);
        if (nearest < 0.003)
            break;
        s += nearest;
    }
    line2(p, eye, eye + min(t, 3.6) * direction, 2.0, INK);
    fill(spots - penWidth(3.0), INK, 1.0);
    number(p, vec2(-1.6, 0.88), parts, 0, INK); // # part(s)
    number(p, vec2(-1.6, 0.76), all, 0, ORANGE); // without cells #
    return sheetColour;
}
