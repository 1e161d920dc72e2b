// The empty circle around a point: drag the point around the solids and into them, and the ball into the box. The
// number is the signed distance. Inside both solids, the circle may fall short of the surface, because the minimum is
// only a lower bound of the depth there.
#include "figure.glsl"
#include "normal.glsl"

uniform vec2 point; // (-0.3, 0.3) handle: where the distance is evaluated
uniform vec2 ball;  // (-1.05, -0.3) handle: centre of the ball

float sceneDistance(vec3 p)
{
    return min(sdCircle(p.xy - ball, 0.42), sdRectangle(p.xy - vec2(0.95, 0.05), vec2(0.5, 0.55)));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0)), f = sceneDistance(vec3(point, 0.0));
    vec2 nearest = point - f * normalAt(vec3(point, 0.0), 1e-3).xy; // go back by f, against the gradient
    fill(d, SAND, 1.0);
    float circle = sdCircle(p - point, abs(f));
    fill(circle, f > 0.0 ? SKY : PAPER, 0.75);
    stroke(circle, 1.5, f > 0.0 ? BLUE : ORANGE);
    stroke(d, 2.0, ORANGE);
    line2(p, point, nearest, 2.0, TEAL);
    dot2(p, nearest, 6.0, TEAL);
    dot2(p, point, 7.0, INK);
    number(p, point + vec2(0.0, 0.09), f, 2, INK); // distance #
    return sheetColour;
}
