// A bent plank: drag the point around it. The radius of the blue circle is the distance that the formula gives for the
// point when it is turned back; this circle may reach into the plank. The radius of the green circle is this distance
// divided by the stretch of the bend; this circle never reaches into the plank. The pale lines connect points where the
// formula gives the same value: where the lines are crowded, the formula changes too fast.
#include "figure.glsl"
#include "transform.glsl"

uniform vec2  point; // (0.42, -0.3) handle: where the formula is evaluated
uniform float rate;  // 0.9 in [-1, 1] step 0.1, radians per unit: how much the plank is bent

const vec2  CENTRE = vec2(0.0, 0.35); // centre of the plank
const float RADIUS = 1.2;             // radius of the cylinder around the centre in which the stretch is bounded

float sceneDistance(vec3 p)
{
    return sdRectangle(opBend(p - vec3(CENTRE, 0.0), rate).xy, vec2(1.1, 0.14));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0)), formula = abs(sceneDistance(vec3(point, 0.0)));
    fill(d, SAND, 1.0);
    contours(d, 0.1, 0.8, PALE);
    fill(length(p - point) - formula, SKY, 0.7);
    stroke(d, 2.5, ORANGE);
    stroke(length(p - point) - formula, 1.5, BLUE);
    stroke(length(p - point) - formula / bendStretch(rate, RADIUS), 1.5, TEAL);
    dot2(p, point, 8.0, INK);
    number(p, vec2(-1.6, 0.88), formula, 2, BLUE); // formula #
    number(p, vec2(-1.6, 0.77), formula / bendStretch(rate, RADIUS), 2, TEAL); // divided #
    return sheetColour;
}
