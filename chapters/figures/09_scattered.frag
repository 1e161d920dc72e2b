// The light of the sky: drag the sun, and the point on the line of sight. The layer of air at this point receives
// sunlight that has passed through the air above, and scatters light that passes through more air on its way to the
// eye. The numbers are the air masses of the whole path in either direction: towards the sun (orange) and along the
// line of sight (blue). On the right is the light that each layer adds in red, green and blue, at its height; above is
// the sum of all layers, the sky.
#include "figure.glsl"
#include "lighting.glsl" // encodeSRGB
#include "sky.glsl"      // RAYLEIGH, transmittance, scatteredLight

uniform vec2 sun;   // (-1.6, -0.18) handle units: direction of the sun, seen from the eye
uniform vec2 layer; // (-0.36, -0.1) handle units: a point on the line of sight

const vec2 EYE = vec2(0.45, -0.8);
const float TOP = 0.4, AIR = 1.2, PLOT = 0.85; // the air reaches from the eye's height to TOP; units

float sceneDistance(vec3 p)
{
    return p.y - EYE.y;
}

// The light that a layer adds, per channel. depth is a fraction, 0 at the top and 1 on the ground.
vec3 addedAt(float depth, float sunMass, float viewMass)
{
    return transmittance(RAYLEIGH, depth * sunMass + (1.0 - depth) * viewMass) * RAYLEIGH * viewMass;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), at = vec2(min(layer.x, PLOT - 0.1), clamp(layer.y, EYE.y + 0.02, TOP));
    vec2 toSun = normalize(vec2(sun.x - EYE.x, max(sun.y - EYE.y, 0.02))), toLayer = normalize(at - EYE);
    float sunMass = min(1.0 / toSun.y, 38.0), viewMass = min(1.0 / toLayer.y, 38.0);
    float depth = (TOP - p.y) / AIR, layerDepth = (TOP - at.y) / AIR;

    if (p.y > EYE.y && p.y < TOP && p.x < PLOT)
        fill(-1.0, mix(PAPER, SKY, 0.3 + 0.07 * floor(10.0 * depth)), 1.0);
    line2(p, vec2(-2.0, TOP), vec2(PLOT, TOP), 1.0, PALE);
    line2(p, vec2(-2.0, EYE.y), vec2(PLOT, EYE.y), 2.0, INK);
    if (p.x < PLOT)
        fill(abs(p.y - at.y) - 0.02, SAND, 1.0);

    // The path of the light, in the colour of the part that remains.
    vec2 space = at + (TOP - at.y + 1.0) * sunMass * toSun;
    float way = clamp(depth, 0.0, layerDepth);
    vec3 added = addedAt(layerDepth, sunMass, viewMass);
    dashes(p, EYE, EYE + 3.0 * toSun, 1.0, ORANGE);
    line2(p, at, space, 6.0, INK);
    line2(p, at, space, 4.0, encodeSRGB(1.1 * transmittance(RAYLEIGH, way * sunMass)));
    line2(p, at, EYE, 6.0, INK);
    line2(p, at, EYE, 4.0, encodeSRGB(added / max(added.r, max(added.g, added.b))));
    dot2(p, at, 9.0, ORANGE);
    dot2(p, EYE, 9.0, INK);
    dot2(p, EYE + length(sun - EYE) * toSun, 24.0, ORANGE);
    number(p, at + 0.3 * toSun + 0.1 * vec2(toSun.y, -toSun.x) * sign(-toSun.x), sunMass, 2, ORANGE); // # | air mass towards the sun #
    number(p, 0.5 * (at + EYE) + vec2(0.17, 0.06), viewMass, 2, BLUE); // # | air mass along the line of sight #

    // The light that each layer adds, and the sum.
    float axis = PLOT + 0.05;
    vec3 here = axis + 2.0 * addedAt(depth, sunMass, viewMass);
    vec3 there = axis + 2.0 * addedAt(depth + 0.01, sunMass, viewMass);
    vec3 slope = (there - here) * 100.0 / AIR;
    if (p.y > EYE.y && p.y < TOP) {
        fill(max(axis - p.x, p.x - max(here.r, max(here.g, here.b))), SKY, 0.4);
        line2(p, vec2(axis, EYE.y), vec2(axis, TOP), 1.0, PALE);
        curve(p.x - here.r, slope.r, 2.5, ORANGE);
        curve(p.x - here.g, slope.g, 2.5, TEAL);
        curve(p.x - here.b, slope.b, 2.5, BLUE);
        dashes(p, vec2(PLOT, at.y), vec2(2.0, at.y), 1.0, PALE);
    }
    vec3 gain = vec3(1.4, 1.75, 3.1); // as in sunlitSky
    float window = sdRectangle(p - vec2(1.3, 0.7), vec2(0.4, 0.17));
    fill(window, encodeSRGB(gain * scatteredLight(RAYLEIGH, viewMass, sunMass)), 1.0);
    stroke(window, 1.5, INK);
    return sheetColour;
}
