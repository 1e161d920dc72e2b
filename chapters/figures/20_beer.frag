// A march through a cloud: drag the ray's start and end, and the lamp; change the density and the number of steps.
// Plotted below, against the distance along the ray, are the share of light that is still transmitted (blue), the share
// that each step hides per 0.2 units (grey), and the part of this share that the lamp lights (orange). The numbers are
// the cover C, and the share A of the lamp's light, both in percent.
#include "figure.glsl"

uniform vec2  eye;     // (-1.6, 0.2) handle: where the ray starts
uniform vec2  aim;     // (-0.2, 0.33) handle: where the ray points
uniform vec2  lamp;    // (0.25, 0.85) handle: direction of the lamp
uniform float density; // 6 in [0, 30] step 0.5, per unit: density of the vapour inside the cloud
uniform int   steps;   // 20 in [2, 40]: steps along the ray

const float LENGTH = 3.2, LOW = -0.85, HIGH = 0.55; // length of the ray; lower end of the plot, and height of 1

// A heap of balls on a flat base.
float sceneDistance(vec3 p)
{
    float heap = min(sdCircle(p.xy - vec2(-0.35, 0.2), 0.3), sdCircle(p.xy - vec2(0.35, 0.15), 0.28));
    heap = min(heap, min(sdCircle(p.xy - vec2(0.0, 0.38), 0.34), sdCircle(p.xy - vec2(0.72, 0.1), 0.18)));
    return max(min(heap, sdCircle(p.xy - vec2(-0.72, 0.1), 0.2)), 0.08 - p.y);
}

float densityAt(vec2 p)
{
    return density * clamp(-10.0 * sceneDistance(vec3(p, 0.0)), 0.0, 1.0);
}

// The share of the lamp's light that reaches a point: Beer's law over a short march.
float lampAt(vec2 p, vec2 toLamp)
{
    float depth = 0.0;
    for (int i = 0; i < 3; i++)
        depth += 0.2 * densityAt(p + 0.2 * (float(i) + 0.5) * toLamp);
    return exp(-depth);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6), toLamp = normalize(lamp - vec2(0.0, 0.25) + 1e-6);
    float share = 1.0 - exp(-0.3 * densityAt(p)), lit = lampAt(p, toLamp);
    fill(sceneDistance(vec3(p, 0.0)), mix(PALE, mix(SKY, vec3(1.0), 0.6), lit), share);
    stroke(sceneDistance(vec3(p, 0.0)), 1.5, BLUE);
    float piece = LENGTH / float(steps), left = 1.0, above = 0.0, along = dot(p - eye, direction), there = 1.0, spot = 1e6;
    vec4 bar = vec4(0.0); // the step at this x: light before and after it, hidden share, lit part of this share
    for (int i = 0; i < steps; i++) {
        float t = (float(i) + 0.5) * piece;
        vec2 at = eye + t * direction;
        float through = exp(-piece * densityAt(at)), hidden = left * (1.0 - through), light = hidden * lampAt(at, toLamp);
        bar = abs(p.x + 1.6 - t) < 0.5 * piece ? vec4(left, left * through, hidden, light) : bar;
        above += light;
        left *= through;
        there = along > t ? left : there;
        spot = min(spot, length(p - at));
    }
    float inStep = fract((p.x + 1.6) / piece), bars = HIGH * 0.2 / piece; // bars show the share hidden per 0.2 units
    float beside = piece * (abs(inStep - 0.5) - 0.5) + 0.003, now = LOW + HIGH * mix(bar.x, bar.y, inStep);
    fill(max(beside, max(LOW - p.y, p.y - LOW - bars * bar.z)), PALE, 1.0);
    fill(max(beside, max(LOW - p.y, p.y - LOW - bars * bar.w)), ORANGE, 1.0);
    line2(p, vec2(-1.6, LOW), vec2(1.6, LOW), 1.5, INK);
    if (abs(p.x) < 1.6)
        curve(p.y - now, HIGH * (bar.y - bar.x) / piece, 2.5, BLUE);
    line2(p, eye, eye + LENGTH * direction, 0.7 + 2.3 * there, INK);
    fill(spot - penWidth(2.5), INK, 1.0);
    dot2(p, eye, 9.0, INK);
    dashes(p, lamp, lamp - 0.25 * toLamp, 1.5, ORANGE);
    dot2(p, lamp, 26.0, ORANGE);
    number(p, vec2(1.3, 0.85), 100.0 * (1.0 - left), 0, BLUE); // # % | cover # percent
    number(p, vec2(1.6, 0.85), 100.0 * above, 0, ORANGE); // # % | lit # percent
    return sheetColour;
}
