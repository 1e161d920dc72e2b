// The march: drag the eye, the aim and the ball. Each step is as long as the radius of the empty circle around its
// start. The number is the count of evaluations. Lower the parameter `most` to 1, and raise it again to watch the march
// advance step by step.
#include "figure.glsl"

uniform vec2 eye;  // (-1.5, 0.45) handle: where the ray starts
uniform vec2 aim;  // (0.0, -0.2) handle: where the ray points
uniform vec2 ball; // (-0.3, 0.5) handle: centre of the ball
uniform int most;  // 40 in [1, 40]: evaluations after which the ray is abandoned

const float FLOOR = -0.65;

float sceneDistance(vec3 p)
{
    return min(p.y - FLOOR, sdCircle(p.xy - ball, 0.4));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);
    float d = sceneDistance(vec3(p, 0.0)), t;
    dashes(p, eye, eye + 6.0 * direction, 1.0, PALE);
    int steps = drawMarch(p, eye, direction, 6.0, 0.004, most, t);
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    dot2(p, eye, 8.0, INK);
    number(p, vec2(-1.6, 0.85), float(steps), 0, INK); // # evaluation(s)
    return sheetColour;
}
