// The mean of stripes over an interval: drag the two ends of the interval. The zigzag rises over even cells and falls
// over odd ones, so the slope of the green chord is the mean: 1 in an even cell, -1 in an odd cell, near 0 over many
// cells. The square on the right shows the mean of the colours.
#include "figure.glsl"

uniform vec2 from; // (-0.76, -0.62) handle units: its x is where the interval begins
uniform vec2 to;   // (-0.28, -0.62) handle units: its x is where the interval ends

const float CELL = 0.4, FOOT = -0.22, HIGH = 0.8; // the side of a cell; the zigzag's lowest value and its height, units

float sceneDistance(vec3 p)
{
    return p.z;
}

// The integral, from 0 to x, of a function that is 1 in even cells and -1 in odd ones.
float zigzag(float x)
{
    return 1.0 - abs(mod(x, 2.0) - 1.0);
}

vec2 onZigzag(float x)
{
    return vec2(x, FOOT + HIGH * zigzag(x / CELL));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float low = min(from.x, to.x), high = max(max(from.x, to.x), low + 0.002), odd = mod(floor(p.x / CELL), 2.0);
    vec2 a = onZigzag(low), b = onZigzag(high), way = normalize(b - a);
    float mean = (zigzag(high / CELL) - zigzag(low / CELL)) / ((high - low) / CELL);

    // The stripes, the interval on them, and the zigzag above.
    float strip = abs(p.y + 0.62) - 0.2, interval = max(low - p.x, p.x - high);
    fill(strip, odd < 0.5 ? PAPER : mix(PALE, PAPER, 0.25), 1.0);
    stroke(strip, 1.5, INK);
    fill(max(interval, abs(p.y - 0.27) - 0.65), SKY, 0.5);
    stroke(max(interval, abs(p.y + 0.62) - 0.24), 2.5, ORANGE);
    dashes(p, vec2(low, -0.38), a, 1.2, ORANGE);
    dashes(p, vec2(high, -0.38), b, 1.2, ORANGE);
    curve(p.y - onZigzag(p.x).y, HIGH / CELL, 2.0, INK);
    dashes(p, a - 4.0 * way, b + 4.0 * way, 1.5, TEAL);
    line2(p, a, b, 3.0, TEAL);
    dot2(p, a, 9.0, TEAL);
    dot2(p, b, 9.0, TEAL);
    dot2(p, vec2(low, -0.62), 9.0, ORANGE);
    dot2(p, vec2(high, -0.62), 9.0, ORANGE);
    number(p, vec2(0.5 * (a.x + b.x), 0.75), mean, 2, TEAL); // mean #
    fill(sdRectangle(p - vec2(1.55, 0.77), vec2(0.14)), mix(mix(PALE, PAPER, 0.25), PAPER, 0.5 + 0.5 * mean), 1.0);
    stroke(sdRectangle(p - vec2(1.55, 0.77), vec2(0.14)), 1.5, INK);
    return sheetColour;
}
