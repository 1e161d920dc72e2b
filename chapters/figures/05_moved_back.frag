// Move the point back: drag the plank, the tip of its axis, and the point p. On the right is the plank in its original
// position, with the point q, which is p moved back, then turned back. The radius of both circles is the value of the
// formula at q, which is shown at the top left. If the parameter `wrongOrder` is on, p is turned back first.
#include "figure.glsl"

uniform vec2 plank;      // (-0.7, -0.25) handle: where the centre of the plank is moved to
uniform vec2 tip;        // (-0.7, 0.15) handle: where the axis of the plank points
uniform vec2 point;      // (-0.7, 0.35) handle: the point p
uniform bool wrongOrder; // false: turn the point back before it is moved back

const float SCALE = 0.2;               // units of the sheet per scene unit
const vec2  LEFT = vec2(-1.3, -0.45);  // origin of the scene
const vec2  RIGHT = vec2(0.85, -0.05); // origin of the plank

// The plank in its original position, scene units.
float sceneDistance(vec3 p)
{
    return sdRectangle(p.xy, vec2(2.0, 0.5));
}

// Apply to q the rotation that takes a direction to the x axis.
vec2 turnedBack(vec2 q, vec2 direction)
{
    return vec2(dot(q, direction), dot(q, vec2(-direction.y, direction.x)));
}

// Draw one half of the sheet: the axes, a plank given by its distance, and a point with a circle of the radius `empty`.
void half2(vec2 p, vec2 origin, float plankDistance, vec2 at, float empty)
{
    arrow(p, origin - vec2(0.35, 0.0), origin + vec2(0.78, 0.0), 1.2, PALE);
    arrow(p, origin - vec2(0.0, 0.35), origin + vec2(0.0, 0.78), 1.2, PALE);
    fill(plankDistance, SAND, 0.9);
    fill(length(p - at) - empty, SKY, 0.7);
    stroke(plankDistance, 2.0, ORANGE);
    stroke(length(p - at) - empty, 1.5, BLUE);
    dot2(p, at, 8.0, BLUE);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(tip - plank + vec2(1e-6, 0.0));
    vec2 q = turnedBack(point - plank, direction) / SCALE;
    if (wrongOrder)
        q = (turnedBack(point - LEFT, direction) - plank + LEFT) / SCALE;
    float empty = abs(sceneDistance(vec3(q, 0.0)));
    if (p.x < 0.0) {
        float d = sceneDistance(vec3(turnedBack(p - plank, direction) / SCALE, 0.0));
        half2(p, LEFT, SCALE * d, point, SCALE * empty);
        arrow(p, LEFT, plank, 1.5, INK);
        line2(p, plank, tip, 1.5, INK);
        dot2(p, plank, 6.0, INK);
        dot2(p, tip, 6.0, INK);
    } else {
        float d = sceneDistance(vec3((p - RIGHT) / SCALE, 0.0));
        half2(p, RIGHT, SCALE * d, RIGHT + SCALE * q, SCALE * empty);
    }
    line2(p, vec2(0.0, -1.0), vec2(0.0, 1.0), 1.0, PALE);
    number(p, vec2(-1.6, 0.88), empty, 2, BLUE); // formula at q #
    return sheetColour;
}
