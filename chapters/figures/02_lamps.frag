// Two lamps above a floor: drag them. The curves below the floor are the light from the warm lamp (orange), the light
// from the cold lamp (blue) and their sum (dark). The dashed line is at 1, the most light that a screen can show. If
// you lower a lamp, its pool of light becomes smaller and brighter.
#include "figure.glsl"
#include "lighting.glsl"

uniform vec2  warm;      // (-0.7, 0.45) handle: the warm lamp
uniform vec2  cold;      // (0.75, 0.7) handle: the cold lamp
uniform float reference; // 0.6 in [0.2, 1.2] step 0.05, units: distance at which a lamp has its own brightness

const float FLOOR = -0.12, AXIS = -0.9, ONE = 0.42; // heights of floor and axis; height of the value 1 above the axis
const vec3 WARM = vec3(1.0, 0.72, 0.45), COLD = vec3(0.45, 0.7, 1.0);

float sceneDistance(vec3 p)
{
    return p.z;
}

// The light that the floor at x receives from a lamp.
float received(vec2 lamp, float x)
{
    vec2 toLamp = lamp - vec2(x, FLOOR);
    float distance = max(length(toLamp), 0.02);
    return fallOff(distance, reference) * lambert(vec3(0.0, 1.0, 0.0), vec3(toLamp / distance, 0.0));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float e = 0.5 * sheetPixel(), a = received(warm, p.x), b = received(cold, p.x);
    float slopeA = (received(warm, p.x + e) - a) / e, slopeB = (received(cold, p.x + e) - b) / e;
    if (p.y < FLOOR - 0.1) {
        float y = p.y - AXIS;
        fill(max(y - ONE * (a + b), -y), SKY, 0.55);
        dashes(p, vec2(-1.9, AXIS + ONE), vec2(1.9, AXIS + ONE), 1.0, PALE);
        curve(y - ONE * a, ONE * slopeA, 2.0, ORANGE);
        curve(y - ONE * b, ONE * slopeB, 2.0, BLUE);
        curve(y - ONE * (a + b), ONE * (slopeA + slopeB), 2.0, INK);
        line2(p, vec2(-1.9, AXIS), vec2(1.9, AXIS), 1.0, INK);
    } else {
        dashes(p, warm, vec2(warm.x, FLOOR), 1.0, PALE);
        dashes(p, cold, vec2(cold.x, FLOOR), 1.0, PALE);
        fill(p.y - FLOOR, encodeSRGB(a * WARM + b * COLD), 1.0); // the lit floor
        dot2(p, warm, 16.0, ORANGE);
        dot2(p, cold, 16.0, BLUE);
    }
    return sheetColour;
}
