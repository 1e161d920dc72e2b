// The phases of the moon: drag the moon around the Earth, and the sun around both. All three are seen from above the
// pole; the sun is so far away that its light comes along parallel lines. On the right is the moon as the eye sees it.
// The numbers are the phase angle in degrees (teal), and the lit share of the disc in percent.
#include "figure.glsl"
#include "lighting.glsl"
#include "night.glsl"

uniform sampler2D moonMap; // "moon.png" linear clamp: brightness and slopes of the moon's ground

uniform vec2 moon; // (-0.93, -0.45) handle: the moon
uniform vec2 sun;  // (-1.62, 0.0) handle: direction of the sun

const vec2  EARTH = vec2(-0.72, 0.0), SEEN = vec2(0.98, 0.04);
const float DISC = 0.6;

float sceneDistance(vec3 p)
{
    return min(sdCircle(p.xy - EARTH, 0.16), sdCircle(p.xy - moon, 0.09));
}

// Draw a ball, half of which is lit by the sun.
void drawBall(vec2 p, vec2 centre, float radius, vec2 toSun, vec3 day, vec3 edge)
{
    float d = sdCircle(p - centre, radius);
    fill(d, day, 1.0);
    fill(max(d, dot(p - centre, toSun)), NIGHT, 1.0);
    stroke(d, 2.0, edge);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), toSun = normalize(sun - EARTH + 1e-6), toEye = normalize(EARTH - moon + 1e-6);
    vec2 beside = vec2(-toSun.y, toSun.x);
    stroke(sdCircle(p - EARTH, length(moon - EARTH)), 1.0, PALE);
    for (int i = -2; i <= 2; i++) // sunlight
        arrow(p, EARTH + 0.82 * toSun + 0.1 * float(i) * beside, EARTH + 0.62 * toSun + 0.1 * float(i) * beside, 1.5, ORANGE);
    dot2(p, sun, 30.0, ORANGE);
    line2(p, EARTH, moon, 1.5, TEAL);
    dashes(p, moon, moon + 0.5 * toSun, 1.5, ORANGE);
    drawBall(p, EARTH, 0.16, toSun, SKY, BLUE);
    drawBall(p, moon, 0.09, toSun, CHALK, INK);
    // The phase angle g, between the directions from the moon to the sun and to the Earth.
    float cosine = dot(toSun, toEye), side = toEye.x * toSun.y - toEye.y * toSun.x, half_ = 0.5 * angleBetween(toSun, toEye);
    vec2 middle = normalize(toSun + toEye + 1e-5 * vec2(-toEye.y, toEye.x)), q = p - moon;
    float arc = sdArc(vec2(dot(q, vec2(middle.y, -middle.x)), dot(q, middle)), 0.19, max(half_, 0.01));
    fill(arc - 0.5 * penWidth(2.0), TEAL, 1.0);
    number(p, moon - 0.19 * middle, degrees(2.0 * half_), 0, TEAL); // #° | phase angle # degrees
    // The disc as an eye on the Earth sees it. inFrame is the direction to the sun: right, up, and towards the eye. It
    // has no upward component, because the sun is in the plane of the sheet.
    vec2 point = (p - SEEN) / DISC;
    vec3 inFrame = vec3(side, 0.0, cosine);
    vec3 face = moonFace(moonMap, point, sheetPixel() / DISC, inFrame, 1.5) * exp(1.2 * half_);
    fill(sdCircle(p - SEEN, 0.7), NIGHT, 1.0);
    fill(length(p - SEEN) - DISC, encodeSRGB(1.0 - exp(-1.1 * face - vec3(0.008, 0.009, 0.013))), 1.0);
    number(p, vec2(SEEN.x, -0.85), 100.0 * moonShare(cosine), 0, INK); // # % lit
    return sheetColour;
}
