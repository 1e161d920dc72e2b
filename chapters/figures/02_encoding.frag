// The mean of two lights: drag the two dots along the curve, which shows the screen's value (vertical) for each amount
// of light (horizontal). The top grey on the right is the encoded mean (the green dot). Seen from afar, the stripes of
// the two lights look like this grey. The lowest grey is the mean of the encoded values (the orange dot), which is too
// dark.
#include "figure.glsl"
#include "lighting.glsl"

uniform vec2 first;  // (-1.3, -0.75) handle: the darker light
uniform vec2 second; // (0.2, 0.75) handle: the brighter light
uniform int  height; // 3 in [1, 20], pixels: height of a stripe

const vec2 CORNER = vec2(-1.3, -0.75); // corner of the graph, where light and value are 0
const float SIDE = 1.5;

float sceneDistance(vec3 p)
{
    return p.z;
}

// The value that is sent to the screen for an amount of light.
float encoded(float light)
{
    return encodeSRGB(vec3(light)).x;
}

// Draw a grey rectangle at height y.
void grey(vec2 p, float y, float value)
{
    fill(sdRectangle(p - vec2(1.05, y), vec2(0.42, 0.25)), vec3(value), 1.0);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), q = (p - CORNER) / SIDE;
    float a = clamp((first.x - CORNER.x) / SIDE, 0.0, 1.0), b = clamp((second.x - CORNER.x) / SIDE, 0.0, 1.0);
    float light = 0.5 * (a + b), right = encoded(light), wrong = 0.5 * (encoded(a) + encoded(b));
    vec2 onA = CORNER + SIDE * vec2(a, encoded(a)), onB = CORNER + SIDE * vec2(b, encoded(b));
    vec2 above = CORNER + SIDE * vec2(light, right), below = CORNER + SIDE * vec2(light, wrong);
    stroke(sdRectangle(q - 0.5, vec2(0.5)) * SIDE, 1.0, PALE);
    line2(p, onA, onB, 1.5, ORANGE);
    dashes(p, above, vec2(above.x, CORNER.y), 1.0, PALE);
    if (q.x >= 0.0 && q.x <= 1.0 && q.y >= 0.0) {
        float slope = (encoded(q.x + 1e-3) - encoded(q.x)) / 1e-3;
        curve(SIDE * (q.y - encoded(q.x)), slope, 2.0, INK);
    }
    dot2(p, onA, 8.0, INK);
    dot2(p, onB, 8.0, INK);
    dot2(p, above, 8.0, TEAL);
    dot2(p, below, 8.0, ORANGE);
    number(p, above + vec2(-0.16, 0.05), right, 3, TEAL); // # | encoded mean #
    number(p, below + vec2(0.18, -0.05), wrong, 3, ORANGE); // # | mean of the codes #
    grey(p, 0.5, right);
    grey(p, 0.0, encoded(((iPixel.y / height) & 1) == 0 ? a : b));
    grey(p, -0.5, wrong);
    stroke(sdRectangle(p - vec2(1.05, 0.0), vec2(0.42, 0.75)), 1.2, INK);
    return sheetColour;
}
