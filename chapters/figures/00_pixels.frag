// The rays of a picture: drag the eye, the ball and the box. A ray goes through each pixel of the screen, the column in
// front of the eye, and the pixel gets the colour of the first surface that the ray meets. Lower the parameter
// `focalLength` to move the screen closer, or raise `pixels` to make the pixels smaller.
#include "figure.glsl"
#include "march.glsl"

uniform vec2 eye;          // (-1.55, 0.05) handle: where all rays start
uniform vec2 ball;         // (0.1, 0.32) handle: centre of the ball
uniform vec2 box;          // (0.95, -0.1) handle: centre of the box
uniform float focalLength; // 0.6 in [0.2, 1.2] step 0.05, units: from the eye to the screen
uniform int pixels;        // 13 in [1, 60]: how many pixels the screen has

const float HALF = 0.42; // half the height of the screen

float ballDistance(vec3 p)
{
    return sdCircle(p.xy - ball, 0.33);
}

float sceneDistance(vec3 p)
{
    return min(ballDistance(p), sdRectangle(p.xy - box, vec2(0.2, 0.55)));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), from = p - eye;
    float side = 2.0 * HALF / float(pixels); // height of a pixel on the screen
    float height = from.y * focalLength / max(from.x, 1e-3);
    height = abs(from.x - focalLength) < 0.05 ? from.y : height; // within the drawn screen, p is not projected
    float k = clamp(floor((height + HALF) / side), 0.0, float(pixels - 1)); // the pixel whose ray passes near p
    vec2 middle = vec2(focalLength, (k + 0.5) * side - HALF), direction = normalize(middle);
    Hit hit = march(Ray(vec3(eye, 0.0), vec3(direction, 0.0)), 0.0, 4.0, 0.002, 80);
    vec2 end = eye + hit.t * direction;
    vec3 colour = !hit.found ? SKY : (ballDistance(vec3(end, 0.0)) < 0.003 ? ORANGE : TEAL);
    float d = sceneDistance(vec3(p, 0.0));
    line2(p, eye, end, 1.0, hit.found ? colour : PALE);
    bool isBall = ballDistance(vec3(p, 0.0)) < d + 1e-6;
    fill(d, isBall ? SAND : mix(PAPER, TEAL, 0.25), 1.0);
    stroke(d, 2.0, isBall ? ORANGE : TEAL);
    if (hit.found)
        dot2(p, end, 5.0, colour);
    vec2 cell = abs(from - middle) - vec2(0.035, 0.5 * side);
    fill(max(cell.x, abs(from.y) - HALF), colour, 1.0);
    stroke(max(cell.x, cell.y), 1.0, INK);
    dot2(p, eye, 9.0, INK);
    return sheetColour;
}
