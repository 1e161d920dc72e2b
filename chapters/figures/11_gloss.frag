// Where a rough surface sends the light: drag the lamp and the eye, and change the roughness. The farther out the curve
// is in a direction, the more light goes in that direction. The orange curve is GGX, and the blue curve is the
// Blinn-Phong highlight. Of the tiny mirrors that make up the surface, the eye sees those whose normal, the green
// arrow, is halfway between the directions to the lamp and to the eye.
#include "figure.glsl"
#include "gloss.glsl" // ggxGloss, blinnPhongGloss, halfway

uniform vec2 lamp;       // (-1.1, 0.6) handle units: where the light comes from
uniform vec2 eye;        // (0.75, 0.75) handle units: where the eye is
uniform float roughness; // 0.5 in [0.2, 1] step 0.02: 0 would be a mirror

const vec2 AT = vec2(0.0, -0.65); // the point on the surface that the light meets
const vec3 UP = vec3(0.0, 1.0, 0.0);

float sceneDistance(vec3 p)
{
    return p.y - AT.y;
}

vec3 towards(vec2 p)
{
    return vec3(normalize(p - AT + 1e-6), 0.0);
}

// How far out the two curves are in a direction: the light that leaves a unit of area.
vec2 leaving(vec3 toEye)
{
    float alpha = roughness * roughness, exponent = 2.0 / (alpha * alpha) - 2.0, cosine = max(toEye.y, 0.0);
    vec3 toLight = towards(lamp);
    float power = toLight.y > 0.0 ? blinnPhongGloss(UP, toLight, toEye, exponent) : 0.0;
    return 0.9 * cosine * vec2(ggxGloss(UP, toLight, toEye, roughness), power);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    vec3 to = towards(p), h = halfway(towards(lamp), towards(eye) + 1e-6);
    float far = length(p - AT);
    vec2 here = leaving(to), there = leaving(vec3(to.x - 0.005 * to.y, to.y + 0.005 * to.x, 0.0));
    vec2 d = (far - here) * inversesqrt(1.0 + pow((there - here) / (0.005 * max(far, 0.02)), vec2(2.0)));
    if (p.y > AT.y) {
        fill(d.x, SAND, 0.8);
        stroke(d.x, 2.2, ORANGE);
        stroke(d.y, 2.2, BLUE);
    }
    fill(p.y - AT.y, mix(PALE, PAPER, 0.5), 1.0);
    line2(p, vec2(-2.0, AT.y), vec2(2.0, AT.y), 2.0, INK);
    dashes(p, AT, AT + vec2(0.0, 1.4), 1.0, PALE);
    vec2 mirror = 0.16 * vec2(-h.y, h.x);
    line2(p, AT - mirror, AT + mirror, 4.0, TEAL);
    arrow(p, AT, AT + 0.8 * h.xy, 2.0, TEAL);
    arrow(p, lamp, AT, 2.0, INK);
    arrow(p, AT, eye, 2.0, INK);
    dot2(p, lamp, 22.0, ORANGE);
    dot2(p, eye, 9.0, INK);
    number(p, AT + 0.92 * h.xy, degrees(angleBetween(h.xy, vec2(0.0, 1.0))), 0, TEAL); // #° | normal at # degrees
    return sheetColour;
}
