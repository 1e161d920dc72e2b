// A hue is an angle: drag the point around the disc of colours. Its angle is the hue, and its distance from the centre
// is the saturation. On the right are the curves of red, green and blue with their values at this hue. The disc treats
// the three numbers as linear light, and the ring around the disc treats them as screen values; the two spots at the
// bottom show the colour in both ways.
#include "figure.glsl"
#include "hue.glsl"
#include "lighting.glsl"

uniform vec2  colour; // (-1.48, 0.335) handle units: its angle is the hue, its distance from the centre the saturation
uniform float value;  // 1 in [0, 1] step 0.05: the largest channel

const vec2  CENTRE = vec2(-0.9, 0.0);  // centre of the disc
const float RADIUS = 0.67;             // radius at which the saturation is 1
const float LEFT = 0.1, WIDTH = 1.38;  // left edge and width of the plots
const float HIGH = 0.42;               // height of a plot

float sceneDistance(vec3 p)
{
    return p.z;
}

// The hue at the point q, relative to the centre of the disc: an angle in degrees from 0 to 360.
float hueAt(vec2 q)
{
    return mod(degrees(atan(q.y, q.x + 1e-6)), 360.0);
}

// Draw the plot of one channel, with its lower edge at the height low.
void plot(vec2 p, int channel, float low, float hue, float saturation)
{
    vec3 ink = vec3(0.12) + 0.58 * vec3(channel == 0, channel == 1, channel == 2);
    ink += 0.3 * step(PAPER.r, 0.5); // lighter on dark paper
    float here = (p.x - LEFT) / WIDTH * 360.0;
    float y = low + HIGH * hsvToRGB(here, saturation, value)[channel];
    float later = low + HIGH * hsvToRGB(here + 1.0, saturation, value)[channel];
    float beside = max(LEFT - p.x, p.x - LEFT - WIDTH);
    fill(max(beside, max(low - p.y, p.y - y)), ink, 0.2);
    for (int i = 0; i <= 6; i++)
        line2(p, vec2(LEFT + float(i) / 6.0 * WIDTH, low), vec2(LEFT + float(i) / 6.0 * WIDTH, low + HIGH), 0.7, PALE);
    line2(p, vec2(LEFT, low), vec2(LEFT + WIDTH, low), 1.2, INK);
    if (beside < 0.0)
        curve(p.y - y, (later - y) * 360.0 / WIDTH, 2.5, ink);
    vec2 at = vec2(LEFT + hue / 360.0 * WIDTH, low + HIGH * hsvToRGB(hue, saturation, value)[channel]);
    line2(p, vec2(at.x, low), at, 1.5, INK);
    dot2(p, at, 7.0, ink);
    number(p, vec2(1.63, low + 0.5 * HIGH), (at.y - low) / HIGH, 2, ink); // # | channel #
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), q = p - CENTRE;
    float hue = hueAt(colour - CENTRE), saturation = min(length(colour - CENTRE) / RADIUS, 1.0);
    fill(length(q) - RADIUS, encodeSRGB(hsvToRGB(hueAt(q), min(length(q) / RADIUS, 1.0), value)), 1.0);
    fill(abs(length(q) - 0.77) - 0.05, hsvToRGB(hueAt(q), 1.0, value), 1.0);
    vec3 numbers = hsvToRGB(hue, saturation, value);
    fill(length(p - vec2(-1.63, -0.86)) - 0.08, encodeSRGB(numbers), 1.0);
    fill(length(p - vec2(-0.17, -0.86)) - 0.08, numbers, 1.0);
    vec2 at = CENTRE + min(length(colour - CENTRE), RADIUS) * normalize(colour - CENTRE + 1e-6);
    line2(p, CENTRE, at, 2.0, INK);
    dot2(p, at, 8.0, INK);
    for (int i = 0; i < 3; i++)
        plot(p, i, 0.4 - 0.6 * float(i), hue, saturation);
    return sheetColour;
}
