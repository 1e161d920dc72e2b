// Two methods along a ray: drag its start and its aim, and change the length of the fixed steps, shown as ticks. At the
// top left are the numbers of evaluations in the march (blue) and with fixed steps (orange). A ring marks where the
// fixed steps stop: in the thin bar or, if they miss it, in the wall behind.
#include "figure.glsl"

uniform vec2 eye;        // (-1.55, 0.5) handle units: where the ray starts
uniform vec2 aim;        // (0.24, -0.07) handle units: where the ray points
uniform float fixedStep; // 0.2 in [0.05, 0.5] step 0.01, units: from one tick to the next

const float FAR = 4.0;

float sceneDistance(vec3 p)
{
    float bar = sdSegment(p.xy, vec2(-0.45, -0.62), vec2(0.75, 0.42)) - 0.015;
    return min(bar, sdRectangle(p.xy - vec2(1.5, 0.0), vec2(0.1, 0.85)));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);
    float d = sceneDistance(vec3(p, 0.0)), t;
    dashes(p, eye, eye + FAR * direction, 1.0, PALE);
    int steps = drawMarch(p, eye, direction, FAR, 0.004, 64, t);

    // The fixed steps continue to the first point inside. The shortest are 0.05 long, so 81 are enough; without a limit, a
    // step of length 0, which a page has not set yet, would never end.
    int evaluations = 1;
    float reached = 0.0;
    for (int i = 0; i < 81 && reached < FAR && sceneDistance(vec3(eye + reached * direction, 0.0)) > 0.0; i++) {
        reached += fixedStep;
        evaluations++;
    }
    vec2 q = vec2(dot(p - eye, direction), dot(p - eye, vec2(-direction.y, direction.x)));
    float tick = clamp(floor(q.x / fixedStep + 0.5) * fixedStep, 0.0, reached);
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    fill(sdRectangle(q - vec2(tick, 0.0), vec2(0.5 * penWidth(2.0), 0.035)), ORANGE, 1.0);
    if (reached < FAR)
        stroke(length(q - vec2(reached, 0.0)) - 0.06, 2.0, ORANGE);
    number(p, vec2(-1.62, 0.87), float(steps), 0, BLUE); // # evaluation(s), march
    number(p, vec2(-1.62, 0.76), float(evaluations), 0, ORANGE); // # evaluation(s), fixed steps
    return sheetColour;
}
