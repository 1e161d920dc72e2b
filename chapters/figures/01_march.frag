// A march in the plane: drag the start of the ray, the point it is aimed at, and the ball. The number of steps
// is at the top left.
#include "figure.glsl"

uniform vec2 eye;  // (-1.55, -0.15) handle: where the ray starts
uniform vec2 aim;  // (0.1, 0.16) handle: where the ray points
uniform vec2 ball; // (-0.35, 0.55) handle: centre of the ball

float sceneDistance(vec3 p)
{
    float box = sdRectangle(p.xy - vec2(1.3, 0.0), vec2(0.22, 0.6));
    return min(min(sdCircle(p.xy - ball, 0.3), box), sdCircle(p.xy - vec2(0.55, -0.65), 0.25));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);
    float d = sceneDistance(vec3(p, 0.0)), t;
    dashes(p, eye, eye + 6.0 * direction, 1.0, PALE);
    int steps = drawMarch(p, eye, direction, 6.0, 0.002, 64, t);
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    number(p, vec2(-1.6, 0.85), float(steps), 0, INK); // # step(s)
    return sheetColour;
}
