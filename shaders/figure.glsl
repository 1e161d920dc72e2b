// figure.glsl - a sheet of paper for the interactive figures of the pages, with pens and numbers.
//
// A figure shows one idea in the plane. It includes this file first, declares its handles (points that the reader
// drags), and defines sceneDistance (the distance in the plane z = 0, or p.z if the figure has none) and rayColour,
// which begins with
//
//     vec2 p = sheetPoint(ray);
//
// draws with the functions below, lowest layer first, and returns sheetColour. Colours are sRGB, as on the page,
// and the same as in the still figures of docs/figures. Lengths are in units of the sheet, which is 2 units high with
// the origin in the centre; widths of lines are in pixels of a picture 360 pixels high.
#define FIGURE
#include "main.glsl"
#include "coverage.glsl"
#include "plane.glsl"
#include "combine.glsl"
#include "signs.glsl"

const vec3 PAPER = vec3(1.000, 0.984, 0.949), INK = vec3(0.051, 0.078, 0.200), PALE = vec3(0.604, 0.627, 0.710);
const vec3 ORANGE = vec3(0.851, 0.451, 0.102), SAND = vec3(0.988, 0.882, 0.722);
const vec3 BLUE = vec3(0.184, 0.435, 0.753), SKY = vec3(0.812, 0.878, 0.961), TEAL = vec3(0.043, 0.498, 0.451);

// A page may draw on dark paper, with other pens. These three are the same there, for what is dark or bright by itself;
// SHADE, for a shadow on the paper, is darker than either paper.
const vec3 NIGHT = vec3(0.051, 0.078, 0.200), CHALK = vec3(1.000, 0.984, 0.949), GLOW = vec3(0.988, 0.882, 0.722);
const vec3 SHADE = vec3(0.604, 0.627, 0.710);

vec3 sheetColour = PAPER; // what has been drawn so far

// The sheet is seen straight from above, wherever the camera is.
Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 1.0), vec3(0.0, 0.0, -1.0));
}

// The point of the sheet that a ray meets.
vec2 sheetPoint(Ray ray)
{
    return ray.origin.xy;
}

// The side of a pixel, in units of the sheet.
float sheetPixel()
{
    return 2.0 / iResolution.y;
}

// The width of a line, in units of the sheet.
//   width  in pixels of a picture 360 pixels high
float penWidth(float width)
{
    return width * max(iResolution.y / 360.0, 1.0) * sheetPixel();
}

// ---- Angles ----
//
// Both functions use atan, because no specification limits the error of a driver's asin and acos.

// The angle in [-pi/2, pi/2] with a given sine.
float arcSine(float s)
{
    return atan(s, sqrt(max(1.0 - s * s, 0.0)));
}

// The angle in [0, pi] between two vectors that are not 0.
float angleBetween(vec2 a, vec2 b)
{
    return atan(abs(a.x * b.y - a.y * b.x), dot(a, b));
}

// ---- Shapes, given by their signed distance d ----

void fill(float d, vec3 colour, float opacity)
{
    sheetColour = mix(sheetColour, colour, opacity * coverage(-d / sheetPixel(), 1.0));
}

void stroke(float d, float width, vec3 colour)
{
    fill(abs(d) - 0.5 * penWidth(width), colour, 1.0);
}

// Lines of equal distance at multiples of a spacing. Their width stays the same even where d is not an exact
// distance and changes faster or more slowly than the position.
void contours(float d, float spacing, float width, vec3 colour)
{
    float slope = clamp(length(vec2(dFdx(d), dFdy(d))) / sheetPixel(), 0.3, 3.0);
    stroke((d - spacing * floor(d / spacing + 0.5)) / slope, width, colour);
}

// ---- Points and lines ----

void dot2(vec2 p, vec2 at, float width, vec3 colour)
{
    fill(length(p - at) - 0.5 * penWidth(width), colour, 1.0);
}

void line2(vec2 p, vec2 a, vec2 b, float width, vec3 colour)
{
    fill(sdSegment(p, a, b + 1e-6) - 0.5 * penWidth(width), colour, 1.0);
}

// A dashed line: each dash is five widths long, and so is each gap.
void dashes(vec2 p, vec2 a, vec2 b, float width, vec3 colour)
{
    float along = dot(p - a, normalize(b - a + 1e-6)) / penWidth(width);
    if (mod(along, 10.0) < 5.0)
        line2(p, a, b, width, colour);
}

// An arrow with its tip at b. Nothing is drawn if a and b are less than a pixel apart.
void arrow(vec2 p, vec2 a, vec2 b, float width, vec3 colour)
{
    if (distance(a, b) < sheetPixel())
        return;
    vec2 along = normalize(b - a + 1e-6), beside = vec2(-along.y, along.x);
    float head = min(penWidth(4.5 * width), 0.6 * length(b - a));
    line2(p, a, b - 0.8 * head * along, width, colour);
    vec2 left = b - head * along + 0.5 * head * beside, right = b - head * along - 0.5 * head * beside;
    fill(sdTriangle(p, b, left, right + 1e-6), colour, 1.0);
}

// Draw the curve y = f(x).
//   above  y - f(x) at the point to be coloured
//   slope  f'(x) there
void curve(float above, float slope, float width, vec3 colour)
{
    fill(abs(above) * inversesqrt(1.0 + slope * slope) - 0.5 * penWidth(width), colour, 1.0);
}

// Draw a number, centred at a point.
//
// In a page, the comment after a call is the number's label, in which # is the number and (s) is left out after 1:
// number(p, at, float(steps), 0, INK); // # step(s). Another label may follow, which a screen reader reads instead:
// // # | distance #. Such a call must not depend on p.
void number(vec2 p, vec2 at, float value, int decimals, vec3 colour)
{
    int scaled = int(floor(value * pow(10.0, float(decimals)) + 0.5)), cell = signCell();
    vec2 size = float(cell) * vec2(float(numberWidth(scaled, decimals)), 5.0);
    float covered = numberCover(scaled, decimals, (p - at) / sheetPixel() + 0.5 * size);
    sheetColour = mix(sheetColour, colour, covered);
}

// ---- A march in the plane ----

// Draw the march of a ray through sceneDistance: the empty circles, the ray, and the points of the march.
//   far, threshold, most  as tMax, threshold and maxSteps of march
//   t        receives where the march ended, along the ray: the hit, or the point after the last step
//   returns  the number of steps
int drawMarch(vec2 p, vec2 from, vec2 direction, float far, float threshold, int most, out float t)
{
    float d = 0.0, inside = 1e6, rim = 1e6, spot = 1e6;
    int steps = 0;
    t = 0.0;
    for (int i = 0; i < most && t < far; i++) {
        vec2 at = from + t * direction;
        d = sceneDistance(vec3(at, 0.0));
        steps++;
        inside = min(inside, length(p - at) - abs(d));
        rim = min(rim, abs(length(p - at) - abs(d)));
        spot = min(spot, length(p - at));
        if (d < threshold)
            break;
        t += d;
    }
    fill(inside, SKY, 0.55);
    stroke(rim, 1.2, BLUE);
    line2(p, from, from + min(t, far) * direction, 2.0, INK);
    fill(spot - penWidth(2.5), INK, 1.0);
    return steps;
}
