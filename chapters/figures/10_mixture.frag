// A mixture of two distances: drag the ray's start, its aim and the right disc, and change the share. With half of
// each, the outline is an ellipse with the centres as its foci. The circles are empty, so the march is safe, but away
// from the line through the foci they do not touch the ellipse: the mixture is less than the distance, and the march
// takes more steps. The number of steps is at the top left.
#include "figure.glsl"

uniform vec2 eye;    // (-1.5, 0.62) handle units: where the ray starts
uniform vec2 aim;    // (0.0, 0.36) handle units: where the ray points
uniform vec2 centre; // (0.5, 0) handle units: centre of the right disc
uniform float morph; // 0.5 in [0, 1] step 0.05: share of the right disc

const vec2 LEFT = vec2(-0.5, 0.0);
const float RADIUS = 0.625;

float sceneDistance(vec3 p)
{
    return mix(sdCircle(p.xy - LEFT, RADIUS), sdCircle(p.xy - centre, RADIUS), morph);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);
    float d = sceneDistance(vec3(p, 0.0)), t;
    // How fast the mixture changes: the length of the weighted mean of two unit vectors, which is less than 1 where
    // they differ.
    float slope = max(length(mix(normalize(p - LEFT + 1e-6), normalize(p - centre + 1e-6), morph)), 0.05);
    dashes(p, eye, eye + 6.0 * direction, 1.0, PALE);
    int steps = drawMarch(p, eye, direction, 6.0, 0.004, 64, t);
    fill(d / slope, SAND, 1.0);
    stroke(length(p - LEFT) - RADIUS, 1.0, PALE);
    stroke(length(p - centre) - RADIUS, 1.0, PALE);
    stroke(d / slope, 2.0, ORANGE);
    dot2(p, LEFT, 6.0, ORANGE);
    dot2(p, centre, 6.0, ORANGE);
    number(p, vec2(-1.62, 0.87), float(steps), 0, BLUE); // # step(s)
    return sheetColour;
}
