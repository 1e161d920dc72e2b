// The footprint of a pixel on a chequered floor, seen from above: drag the eye and the pixel. Blue is the part of the
// floor that the pixel covers, between the rays through its corners. Orange is the rectangle that is averaged; the
// square at the top right shows the mean of this rectangle. The pale lines are the borders of all pixels.
#include "figure.glsl"
#include "checkers.glsl" // checkers

uniform vec2 eye;        // (-0.35, -0.85) handle units: point on the floor below the eye, which looks towards the top
uniform vec2 pixel;      // (0.35, 0.3) handle units: the middle of the pixel
uniform float height;    // 0.5 in [0.1, 1.5] step 0.05, units: height of the eye above the floor
uniform float pixelSize; // 0.12 in [0.01, 0.3] step 0.01: side of a pixel on a screen at the distance 1

const float SQUARE = 0.4; // side of a square, units

float sceneDistance(vec3 p)
{
    return p.z;
}

// Map a point of the floor to its position on the screen, and back.
vec2 screenAt(vec2 p)
{
    return vec2(p.x - eye.x, -height) / max(p.y - eye.y, 0.001);
}

vec2 floorAt(vec2 screen)
{
    return eye + height / max(-screen.y, 0.001) * vec2(screen.x, 1.0);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), here = screenAt(p), middle = screenAt(pixel), side = vec2(0.5 * pixelSize);
    vec2 a = floorAt(middle + side * vec2(-1, -1)), b = floorAt(middle + side * vec2(1, -1));
    vec2 c = floorAt(middle + side * vec2(1, 1)), d = floorAt(middle + side * vec2(-1, 1));
    vec2 low = min(min(a, b), min(c, d)), high = max(max(a, b), max(c, d)), centre = 0.5 * (low + high);
    vec3 dark = mix(PALE, PAPER, 0.45);

    vec2 odd = mod(floor(p / SQUARE), 2.0);
    fill(-1.0, odd.x == odd.y ? PAPER : dark, 1.0);
    if (p.y > eye.y + 0.02) { // the borders of the pixels
        // How far the position on the screen moves, perpendicular to each kind of border, per unit on the floor.
        vec2 rate = vec2(length(vec2(1.0, here.x)), height / (p.y - eye.y)) / (p.y - eye.y);
        vec2 apart = abs(fract((here - middle) / pixelSize) - 0.5) * pixelSize / rate;
        vec2 seen = smoothstep(vec2(2.0), vec2(8.0), pixelSize / rate / penWidth(1.0)); // borders fade where they crowd
        fill(apart.x - 0.4 * penWidth(1.0), PALE, seen.x);
        fill(apart.y - 0.4 * penWidth(1.0), PALE, seen.y);
    }
    fill(sdRectangle(p - centre, 0.5 * (high - low)), SAND, 0.6);
    vec2 outside = abs(here - middle) - side;
    if (p.y > eye.y && max(outside.x, outside.y) < 0.0)
        fill(-1.0, BLUE, 0.35);
    line2(p, a, b, 2.0, BLUE);
    line2(p, b, c, 2.0, BLUE);
    line2(p, c, d, 2.0, BLUE);
    line2(p, d, a, 2.0, BLUE);
    stroke(sdRectangle(p - centre, 0.5 * (high - low)), 2.0, ORANGE);
    dashes(p, eye, pixel, 1.2, INK);
    dot2(p, eye, 10.0, INK);
    dot2(p, pixel, 7.0, INK);
    float share = checkers(centre / SQUARE, max(high - low, 1e-3) / SQUARE);
    fill(sdRectangle(p - vec2(1.55, 0.77), vec2(0.14)), mix(dark, PAPER, share), 1.0);
    stroke(sdRectangle(p - vec2(1.55, 0.77), vec2(0.14)), 2.0, ORANGE);
    return sheetColour;
}
