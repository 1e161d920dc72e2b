// A star and the pixels: drag the star, and change the radius of its spot. Each pixel takes one sample, at its centre;
// the number in a pixel is the share of the star's light that the pixel shows, in percent. The curve is the sum of all
// pixels, in percent, as the star moves to the right by four pixels: if the curve is flat, stars do not flicker.
#include "figure.glsl"

uniform vec2  star;   // (-0.66, 0.06) handle: the star
uniform float radius; // 1.761 in [0.3, 2.4] step 0.05, pixels: radius of the spot

const float SIDE = 0.24;                                     // side of a pixel on the sheet
const vec2  CORNER = vec2(-1.68, -0.84);                     // lower left corner of the 8 x 7 pixels
const vec2  LOW = vec2(0.62, -0.6), HIGH = vec2(1.6, 0.6); // corners of the plot: sums from 0 to 200 %

float sceneDistance(vec3 p)
{
    return p.z;
}

// The light of a star at an offset from its centre, in pixels. The integral over the plane is 1.
float spotLight(vec2 away)
{
    float inside = max(1.0 - dot(away, away) / (radius * radius), 0.0);
    return 4.0 / (3.1415927 * radius * radius) * inside * inside * inside;
}

// The sum over all pixels for a star at a point, in pixels.
float spotSum(vec2 at)
{
    float sum = 0.0;
    for (int i = -3; i <= 3; i++)
        for (int j = -3; j <= 3; j++)
            sum += spotLight(floor(at) + 0.5 + vec2(i, j) - at);
    return sum;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), at = (star - CORNER) / SIDE, pixel = floor((p - CORNER) / SIDE);
    float frame = sdRectangle(p - CORNER - SIDE * vec2(4.0, 3.5), SIDE * vec2(4.0, 3.5));
    float light = spotLight(pixel + 0.5 - at);
    fill(frame, mix(NIGHT, CHALK, sqrt(min(2.0 * light, 1.0))), 1.0);
    vec2 edge = abs(p - CORNER - SIDE * floor((p - CORNER) / SIDE + 0.5));
    fill(max(frame, min(edge.x, edge.y) - 0.5 * penWidth(1.0)), PALE, 0.6);
    if (frame < 0.0 && light > 0.005)
        number(p, CORNER + SIDE * (pixel + 0.5), 100.0 * light, 0, light > 0.1 ? NIGHT : CHALK);
    stroke(frame, 2.0, INK);
    stroke(sdCircle(p - star, radius * SIDE), 2.0, ORANGE);
    dot2(p, star, 8.0, ORANGE);

    vec2 in_ = (p - LOW) / (HIGH - LOW);
    line2(p, LOW, vec2(HIGH.x, LOW.y), 1.5, INK);
    line2(p, LOW, vec2(LOW.x, HIGH.y), 1.5, INK);
    dashes(p, vec2(LOW.x, 0.0), vec2(HIGH.x, 0.0), 1.0, PALE);
    float start = floor(at.x) - 2.0, x = start + 4.0 * in_.x, sum = spotSum(vec2(x, at.y)), step_ = 0.01;
    float slope = (spotSum(vec2(x + step_, at.y)) - sum) / step_ * 0.5 * (HIGH - LOW).y / (0.25 * (HIGH - LOW).x);
    if (in_.x > 0.0 && in_.x < 1.0 && in_.y < 1.05)
        curve((in_.y - 0.5 * sum) * (HIGH - LOW).y, slope, 2.5, TEAL);
    float now = spotSum(at);
    vec2 spot = mix(LOW, HIGH, vec2((at.x - start) / 4.0, 0.5 * min(now, 2.1)));
    dashes(p, vec2(spot.x, LOW.y), spot, 1.0, ORANGE);
    dot2(p, spot, 9.0, ORANGE);
    number(p, vec2(spot.x, -0.72), 100.0 * now, 1, ORANGE); // # % | sum # percent
    number(p, vec2(0.52, 0.0), 100.0, 0, PALE); // # |
    return sheetColour;
}
