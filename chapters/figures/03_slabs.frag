// A box is the intersection of two slabs: drag the start of the ray and its aim. The bars below show where the ray is
// in the upright slab (orange), in the horizontal slab (blue) and in both slabs (green). The green bar reaches from the
// later entry to the earlier exit; the two numbers are the values of t at these points.
#include "figure.glsl"
#include "bounds.glsl"

uniform vec2 start; // (-0.9, 0.2) handle: where the ray starts
uniform vec2 aim;   // (-0.3, 0.65) handle: where the ray points

const float UNIT = 0.3; // length of a scene unit on the sheet
const vec2 CORNER = vec2(-0.6, 0.05), SIZE = vec2(4.0, 2.0) * UNIT;

float sceneDistance(vec3 p)
{
    return p.z;
}

// Draw a bar for an interval of t.
void bar(vec2 p, float y, vec2 interval, vec3 colour)
{
    vec2 x = vec2(-1.3) + 1.5 * UNIT * clamp(interval, 0.0, 7.0);
    if (x.y > x.x)
        fill(sdRectangle(p - vec2(0.5 * (x.x + x.y), y), vec2(0.5 * (x.y - x.x), 0.04)), colour, 1.0);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - start + 1e-6), high = CORNER + SIZE;
    Ray along = Ray(vec3(start, 0.0) / UNIT, vec3(direction, 0.0));
    vec3 low = vec3(CORNER / UNIT, -1.0), top = vec3(high / UNIT, 1.0);
    vec2 upright = boxInterval(along, vec3(low.x, -1e3, -1.0), vec3(top.x, 1e3, 1.0));
    vec2 flat2 = boxInterval(along, vec3(-1e3, low.y, -1.0), vec3(1e3, top.y, 1.0));
    vec2 both = boxInterval(along, low, top);
    if (p.y > -0.4) {
        fill(abs(p.x - CORNER.x - 0.5 * SIZE.x) - 0.5 * SIZE.x, SAND, 0.8);
        fill(abs(p.y - CORNER.y - 0.5 * SIZE.y) - 0.5 * SIZE.y, SKY, 0.7);
        stroke(sdRectangle(p - CORNER - 0.5 * SIZE, 0.5 * SIZE), 2.0, INK);
        arrow(p, start, start + 9.0 * direction, 1.5, INK);
        if (both.y > both.x) {
            line2(p, start + UNIT * both.x * direction, start + UNIT * both.y * direction, 4.0, TEAL);
            dot2(p, start + UNIT * both.x * direction, 9.0, TEAL);
            dot2(p, start + UNIT * both.y * direction, 9.0, TEAL);
        }
        dot2(p, start, 9.0, INK);
        return sheetColour;
    }
    bar(p, -0.52, upright, ORANGE);
    bar(p, -0.66, flat2, BLUE);
    bar(p, -0.8, both, TEAL);
    line2(p, vec2(-1.3, -0.45), vec2(-1.3, -0.88), 1.2, INK);
    if (both.y > both.x) {
        number(p, vec2(-1.3 + 1.5 * UNIT * min(both.x, 7.0), -0.93), both.x, 2, TEAL); // # | entry at t = #
        number(p, vec2(-1.3 + 1.5 * UNIT * min(both.y, 7.0), -0.93), both.y, 2, TEAL); // # | exit at t = #
    }
    return sheetColour;
}
