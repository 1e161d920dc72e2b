// A ray that meets a floor: drag the eye and the aim until the ray grazes the floor. The number of steps is on the
// left. On the right is the fraction of the distance that remains after each step: 1 minus the sine of the angle
// between the ray and the floor. Each halving of the threshold adds the same few steps.
#include "figure.glsl"

uniform vec2 eye;        // (-1.5, 0.4) handle: where the ray starts
uniform vec2 aim;        // (0.3, -0.35) handle: where the ray points
uniform float threshold; // 0.004 in [0.00001, 0.1] step *2, units: a distance below this counts as a hit

const float FLOOR = -0.7;

float sceneDistance(vec3 p)
{
    return p.y - FLOOR;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);
    float d = sceneDistance(vec3(p, 0.0)), t;
    dashes(p, eye, eye + 8.0 * direction, 1.0, PALE);
    int steps = drawMarch(p, eye, direction, 40.0, threshold, 120, t);
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    dot2(p, eye, 7.0, INK);
    dot2(p, aim, 6.0, TEAL);
    number(p, vec2(-1.6, 0.85), float(steps), 0, INK); // # step(s)
    number(p, vec2(1.55, 0.85), 1.0 - clamp(-direction.y, 0.0, 1.0), 2, TEAL); // # remains
    return sheetColour;
}
