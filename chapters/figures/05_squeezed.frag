// A ball squeezed in x: drag the start of the ray and the point it is aimed at, and change the squeeze. The inverse map
// stretches lengths, so the steps are too long: the circles reach into the solid, and the march may miss it. If the
// distance is divided by the largest stretch, the circles stay outside. The number of steps is at the top left.
#include "figure.glsl"
#include "transform.glsl"

uniform vec2  eye;     // (-0.36, -0.1) handle: where the ray starts
uniform vec2  aim;     // (0.25, 0.02) handle: where the ray points
uniform float squeeze; // 2.75 in [1, 4] step 0.25: the inverse map stretches x by this factor
uniform bool  divided; // false: divide the distance by the largest stretch

const vec2 CENTRE = vec2(0.1, 0.0); // centre of the ball

float sceneDistance(vec3 p)
{
    mat3 m = mat3(squeeze, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    float d = sdCircle((m * (p - vec3(CENTRE, 0.0))).xy, 0.4);
    return divided ? d / largestStretch(m) : d;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);
    float d = sceneDistance(vec3(p, 0.0)), far = max(dot(CENTRE - eye, direction) + 0.5, 0.5), t;
    contours(d, 0.2, 0.8, PALE);
    fill(d, SAND, 1.0);
    dashes(p, eye, eye + 6.0 * direction, 1.0, INK);
    int steps = drawMarch(p, eye, direction, far, 0.002, 64, t);
    stroke(d, 2.5, ORANGE);
    line2(p, eye, eye + t * direction, 2.0, INK);
    dot2(p, eye, 7.0, INK);
    dot2(p, eye + t * direction, 7.0, INK);
    number(p, vec2(-1.6, 0.88), float(steps), 0, INK); // # step(s)
    return sheetColour;
}
