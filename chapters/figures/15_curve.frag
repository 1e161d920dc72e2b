// The curve of a film: drag the white point and the light to the left and right. Plotted against the light, in stops
// from middle grey, are its clamped value (pale), a smoothstep (orange) and the film (blue). Below is a colour that
// gets brighter: clamped, with the film on each channel, and with the film on the largest channel. The numbers are the
// selected light, in stops, and the film's result for it.
#include "figure.glsl"
#include "film.glsl"
#include "lighting.glsl"

uniform vec2 white;  // (1.37, 0.85) handle: its x is the light that becomes 1
uniform vec2 spot;   // (0.5, -0.4) handle: its x is the selected light
uniform float gamma; // 1.45 in [1, 3] step 0.05: steepness of the film's curve
uniform vec3 colour; // 1, 0.4, 0.05 in [0, 1], linear RGB: colour of the strips

const vec2 LOW = vec2(0.0, -0.4); // origin of the plot: middle grey, and the result 0
const float STOP = 0.25, HIGH = 1.25; // width of a stop, and height of the value 1, units

float sceneDistance(vec3 p)
{
    return p.z;
}

// The results of all three curves for a light.
vec3 shownOf(float light, float whiteLight)
{
    return vec3(min(light, 1.0), smoothstep(0.0, 1.0, light), filmCurve(vec3(light), gamma, whiteLight).r);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float whiteLight = 0.18 * exp2(clamp((white.x - LOW.x) / STOP, 2.6, 7.0));
    float stops = (p.x - LOW.x) / STOP, light = 0.18 * exp2(stops);
    vec3 shown = shownOf(light, whiteLight);
    if (p.y > LOW.y - 0.02 && p.y < LOW.y + HIGH + 0.02) {
        float wide = 0.02;
        vec3 slope = HIGH * (shownOf(0.18 * exp2(stops + wide), whiteLight) - shown) / (wide * STOP);
        vec3 above = p.y - LOW.y - HIGH * shown;
        line2(p, vec2(-1.78, LOW.y + HIGH), vec2(1.78, LOW.y + HIGH), 1.0, PALE);
        dashes(p, vec2(-1.78, LOW.y + 0.18 * HIGH), vec2(LOW.x, LOW.y + 0.18 * HIGH), 1.0, PALE);
        fill(max(LOW.y - p.y, above.z), SKY, 0.6);
        fill(max(abs(fract(stops + 0.5) - 0.5) * STOP - penWidth(0.5), p.y - LOW.y - 0.04), INK, 1.0);
        curve(above.x, slope.x, 1.6, PALE);
        curve(above.y, slope.y, 1.6, ORANGE);
        curve(above.z, slope.z, 2.4, BLUE);
    }
    line2(p, vec2(-1.78, LOW.y), vec2(1.78, LOW.y), 1.5, INK);
    dot2(p, LOW + vec2(0.0, 0.18 * HIGH), 7.0, INK);
    dot2(p, LOW + vec2(STOP * log2(whiteLight / 0.18), HIGH), 9.0, BLUE);

    // The strips: the light of the colour's largest channel equals the light in the plot above.
    float strip = (LOW.y - 0.08 - p.y) / 0.16;
    if (strip > 0.0 && strip < 3.0) {
        vec3 bright = light * colour / max(max(colour.r, max(colour.g, colour.b)), 1e-3);
        vec3 film = strip < 2.0 ? filmCurve(bright, gamma, whiteLight) : filmOfLargest(bright, gamma, whiteLight);
        sheetColour = abs(fract(strip + 0.5) - 0.5) < 0.05 ? PAPER : encodeSRGB(strip < 1.0 ? bright : film);
    }

    // The selected light, on all three curves.
    float at = (spot.x - LOW.x) / STOP;
    vec3 there = shownOf(0.18 * exp2(at), whiteLight);
    dashes(p, vec2(spot.x, LOW.y - 0.56), vec2(spot.x, LOW.y + HIGH), 1.2, INK);
    dot2(p, vec2(spot.x, LOW.y + HIGH * there.x), 8.0, PALE);
    dot2(p, vec2(spot.x, LOW.y + HIGH * there.y), 8.0, ORANGE);
    dot2(p, vec2(spot.x, LOW.y + HIGH * there.z), 8.0, BLUE);
    number(p, vec2(-1.55, 0.68), at, 1, INK); // light # stop(s)
    number(p, vec2(-1.55, 0.56), there.z, 2, BLUE); // film #
    return sheetColour;
}
