// The ray to the lamp: drag the lamp, the ball and the aim. The ray from the eye meets a surface. A second march goes
// from slightly above this surface to the lamp; it is green if it arrives and orange if the ball blocks it. The light
// of the lamp does not reach the dark stretch of the ground.
#include "figure.glsl"
#include "normal.glsl"
#include "shadow.glsl"

uniform vec2 lamp; // (0.95, 0.8) handle: the lamp
uniform vec2 ball; // (0.1, 0.0) handle: centre of the ball
uniform vec2 aim;  // (-0.55, -0.6) handle: where the eye looks

const vec2 EYE = vec2(-1.55, 0.55);
const float GROUND = -0.6, THRESHOLD = 0.002, OFFSET = 4.0 * THRESHOLD;

float sceneDistance(vec3 p)
{
    return min(p.y - GROUND, sdCircle(p.xy - ball, 0.28));
}

// The ray to the lamp from a point on a surface.
Ray toLamp(vec3 p, vec3 normal)
{
    return shadowRay(p, normal, vec3(normalize(lamp - p.xy + 1e-6), 0.0), OFFSET);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0)), t = 0.0;
    vec3 below = vec3(p.x, GROUND, 0.0); // the point on the ground at p.x
    Ray up = toLamp(below, vec3(0.0, 1.0, 0.0));
    float far = shadowReach(vec3(0.0, 1.0, 0.0), up.direction, length(lamp - below.xy));
    bool dark = far == 0.0 || lightReaching(up, far, THRESHOLD, 80) == 0.0;
    Ray eyeRay = Ray(vec3(EYE, 0.0), vec3(normalize(aim - EYE + 1e-6), 0.0));
    Hit hit = march(eyeRay, 0.0, 6.0, THRESHOLD, 120);
    vec3 at = eyeRay.origin + hit.t * eyeRay.direction, normal = normalAt(at, 1e-3);
    Ray second = toLamp(at, normal);
    far = hit.found ? shadowReach(normal, second.direction, length(lamp - at.xy)) : 0.0;
    int steps = drawMarch(p, second.origin.xy, second.direction.xy, far, THRESHOLD, 80, t);
    fill(d, SAND, 1.0);
    if (dark)
        fill(max(p.y - GROUND, GROUND - 0.1 - p.y), NIGHT, 0.75);
    stroke(d, 2.0, ORANGE);
    bool lit = far > 0.0 && t >= far;
    if (far > 0.0)
        line2(p, second.origin.xy, second.origin.xy + min(t, far) * second.direction.xy, 2.5, lit ? TEAL : ORANGE);
    if (hit.found && distance(EYE, aim) > hit.t)
        dashes(p, at.xy, aim, 1.0, PALE); // the aim is behind what the ray meets
    arrow(p, EYE, at.xy, 2.0, INK);
    dot2(p, EYE, 10.0, INK);
    dot2(p, lamp, 16.0, ORANGE);
    dot2(p, lamp, 9.0, SAND);
    number(p, vec2(-1.6, 0.85), far > 0.0 ? float(steps) : 0.0, 0, lit ? TEAL : ORANGE); // # step(s) to the lamp
    return sheetColour;
}
