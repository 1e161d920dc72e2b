// Plaster and dust: drag the sun around the moon, which is seen from above on the left, with the eye far below. The
// discs are what the eye sees: Lambert's law is used in the middle, and that of Lommel and Seeliger on the right; each
// curve is the brightness across the disc. Drag the point to compare the two. At full moon, with the sun behind the
// eye, the plaster is dark at the rim of the disc, and the dust is equally bright everywhere.
#include "figure.glsl"
#include "lighting.glsl"

uniform vec2 sun; // (-0.85, -0.75) handle: direction of the sun
uniform vec2 at;  // (0.27, 0.45) handle: a point on the disc

const vec2  MOON = vec2(-1.2, 0.1);
const float RADIUS = 0.42, LOW = -0.82, HIGH = 0.4; // radius of a disc; lower end of a plot; height of the brightness 1

float sceneDistance(vec3 p)
{
    return sdCircle(p.xy - MOON, RADIUS);
}

// The brightness of the ground at point q of the disc, where q is in radii: 1 at the centre of a full moon.
float groundLight(vec2 q, vec3 toSun, bool dust)
{
    float m = sqrt(max(1.0 - dot(q, q), 0.0)), sunlit = max(dot(vec3(q, m), toSun), 0.0);
    return dust ? 2.0 * sunlit / max(sunlit + m, 1e-3) : sunlit;
}

// Draw a disc and the curve below it.
void drawLaw(vec2 p, float x, vec3 toSun, bool dust, float chosen)
{
    vec2 q = (p - vec2(x, 0.45)) / RADIUS;
    fill(sdRectangle(q, vec2(1.12)) * RADIUS, NIGHT, 1.0);
    fill((length(q) - 1.0) * RADIUS, encodeSRGB(vec3(0.8) * groundLight(q, toSun, dust)), 1.0);
    fill((length(q) - 1.0) * RADIUS, CHALK, 0.06);
    line2(p, vec2(x - RADIUS, LOW), vec2(x + RADIUS, LOW), 1.5, INK);
    dashes(p, vec2(x - RADIUS, LOW + HIGH), vec2(x + RADIUS, LOW + HIGH), 1.0, PALE);
    vec2 low = vec2(clamp(q.x - 0.01, -0.999, 0.979), 0.0), high = low + vec2(0.02, 0.0);
    float light = groundLight(vec2(q.x, 0.0), toSun, dust), rise = groundLight(high, toSun, dust) - groundLight(low, toSun, dust);
    if (abs(q.x) < 1.0 && p.y < -0.06 && p.y > LOW - 0.01)
        curve(p.y - LOW - HIGH * light, HIGH * rise / (0.02 * RADIUS), 2.5, BLUE);
    vec2 spot = vec2(x + RADIUS * chosen, LOW + HIGH * groundLight(vec2(chosen, 0.0), toSun, dust));
    dashes(p, vec2(spot.x, 0.45), vec2(spot.x, LOW), 1.0, ORANGE);
    dot2(p, vec2(spot.x, 0.45), 8.0, ORANGE);
    dot2(p, vec2(spot.x, min(spot.y, -0.06)), 8.0, ORANGE);
    number(p, vec2(spot.x, LOW - 0.09), groundLight(vec2(chosen, 0.0), toSun, dust), 2, ORANGE); // # | brightness #
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), toSun = normalize(sun - MOON + 1e-6);
    vec3 inFrame = vec3(toSun.x, 0.0, -toSun.y); // right, up, to the eye
    float d = sceneDistance(vec3(p, 0.0)), chosen = clamp((at.x - 0.15) / RADIUS, -0.999, 0.999);
    fill(d, CHALK, 1.0);
    fill(max(d, dot(p - MOON, toSun)), NIGHT, 1.0);
    stroke(d, 2.0, INK);
    vec2 ground = MOON + RADIUS * vec2(chosen, -sqrt(1.0 - chosen * chosen));
    dashes(p, ground, vec2(ground.x, -0.9), 1.5, BLUE);
    arrow(p, ground, ground + 0.25 * (ground - MOON) / RADIUS, 2.0, INK);
    arrow(p, ground + 0.34 * toSun, ground + 0.02 * toSun, 2.0, ORANGE);
    dot2(p, ground, 8.0, ORANGE);
    dot2(p, sun, 26.0, ORANGE);
    drawLaw(p, 0.15, inFrame, false, chosen);
    drawLaw(p, 1.2, inFrame, true, chosen);
    return sheetColour;
}
