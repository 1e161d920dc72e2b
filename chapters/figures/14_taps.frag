// Five taps: drag the point along the floor, and the corners of both walls. A tap is blue if it finds nothing, and
// orange if it finds a wall, at the dot; the dashed orange lines are the tangents from the point to the circle of the
// last tap. The bars on the right, and the numbers, are the openness (blue) and its estimate from the taps (orange).
#include "figure.glsl"
#include "occlusion.glsl"

uniform vec2 spot;      // (-0.55, -0.75) handle: its x is the position of the point
uniform vec2 left;      // (-0.85, 0.8) handle: corner of the left wall
uniform vec2 right;     // (0.35, 0.8) handle: corner of the right wall
uniform float strength; // 1 in [0, 1] step 0.05: how much of the light a tap removes

const float FLOOR = -0.75, REACH = 1.28;

float sceneDistance(vec3 p)
{
    vec2 beyond = max(vec2(p.x - left.x, p.y - left.y), vec2(0.0));
    vec2 before = max(vec2(right.x - p.x, p.y - right.y), vec2(0.0));
    float inLeft = min(max(p.x - left.x, p.y - left.y), 0.0), inRight = min(max(right.x - p.x, p.y - right.y), 0.0);
    return min(p.y - FLOOR, min(length(beyond) + inLeft, length(before) + inRight));
}

void bar(vec2 p, float x, float share, vec3 colour)
{
    fill(sdRectangle(p - vec2(x, FLOOR + 0.5 * share), vec2(0.06, 0.5 * share)), colour, 1.0);
    stroke(sdRectangle(p - vec2(x, FLOOR + 0.5), vec2(0.06, 0.5)), 1.2, colour);
    number(p, vec2(x, FLOOR - 0.1), share, 2, colour); // # | openness #
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), point = vec2(clamp(spot.x, left.x + 0.01, max(right.x, left.x + 0.02) - 0.01), FLOOR);
    float edge = 1.1, d = sceneDistance(vec3(p, 0.0));
    vec2 toLeft = left - point, toRight = right - point;
    if (p.x < edge) {
        // The sky between the tops of the walls.
        vec2 q = p - point;
        fill(max(max(-q.x * toLeft.y + q.y * toLeft.x, q.x * toRight.y - q.y * toRight.x), -q.y), SKY, 0.5);
        fill(d, SAND, 1.0);
        stroke(d, 2.0, ORANGE);
        dashes(p, point, point + vec2(0.0, REACH), 1.2, INK);
        for (int k = 0; k < TAPS; k++) {
            float height = tapHeight(k, REACH);
            vec2 tap = point + vec2(0.0, height);
            float near = sceneDistance(vec3(tap, 0.0));
            bool found = near < height - 1e-4;
            stroke(length(p - tap) - max(near, 0.0), 1.5, found ? ORANGE : BLUE);
            dot2(p, tap, 6.0, INK);
            if (found && near > 0.0) {
                vec2 e = vec2(0.001, 0.0), off = tap - 2.0 * e; // off the middle, where both walls are equally near
                vec2 away = vec2(sceneDistance(vec3(off + e.xy, 0.0)) - sceneDistance(vec3(off - e.xy, 0.0)),
                                 sceneDistance(vec3(off + e.yx, 0.0)) - sceneDistance(vec3(off - e.yx, 0.0)));
                dot2(p, tap - near * normalize(away + 1e-9), 8.0, ORANGE);
                if (k == TAPS - 1) {
                    float sine = near / height, cosine = sqrt(1.0 - sine * sine);
                    dashes(p, point, point + 1.6 * vec2(sine, cosine), 1.4, ORANGE);
                    dashes(p, point, point + 1.6 * vec2(-sine, cosine), 1.4, ORANGE);
                }
            }
        }
        dot2(p, point, 10.0, INK);
    }
    float open = openBeforeWall(-toLeft.x, max(toLeft.y, 1e-3)) + openBeforeWall(toRight.x, max(toRight.y, 1e-3)) - 1.0;
    bar(p, 1.3, open, BLUE);
    bar(p, 1.55, openByTaps(vec3(point, 0.0), vec3(0.0, 1.0, 0.0), REACH, strength), ORANGE);
    return sheetColour;
}
