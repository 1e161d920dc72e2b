// 10 Distance in the plane: a figure on a sheet, its distance printed as lines, and one ray.

#include "main.glsl"     // main(): calls pixelRay, then rayColour
#include "camera.glsl"   // focalLength, perspectiveRay
#include "march.glsl"    // march
#include "marched.glsl"  // marchedSteps, marchedStep, marchedHit
#include "normal.glsl"   // normalAt
#include "plane.glsl"    // sdCircle, sdSegment, sdRectangle, sdTriangle, sdPolygon, sdArc, opRound, opOnion
#include "combine.glsl"  // opUnion, opIntersection, opSubtraction, opSmoothUnion
#include "coverage.glsl" // coverage, blurred
#include "lighting.glsl" // encodeSRGB

uniform int   figure;       // 6 in [0, 8]: 0 disc, 1 bar, 2 rectangle, 3 triangle, 4 dart, 5 arc, 6 leaf, 7 half-plane, 8 point
uniform int   operation;    // 0 in [0, 6]: 0 none; with a disc 1 union, 2 intersection, 3 difference, 4 smooth union; 5 onion, 6 round
uniform float amount;       // 0.1 in [0.01, 0.5] step 0.01, units: width of the blend, the shell or the rounding
uniform float morph;        // 0 in [0, 1] step 0.05: how far the distance is mixed with that of the disc
uniform vec2  rayStart;     // -1.85, -0.75 in [-10, 10] step 0.05, handle units: where the ray starts; drag it
uniform vec2  aim;          // -0.45, -0.06 in [-10, 10] step 0.05, handle units: a point that the ray passes through; drag it
uniform float fixedStep;    // 0 in [0, 0.5] step 0.02, units: length of the fixed steps, shown as ticks along the ray; 0: none
uniform float lineSpacing;  // 0.05 in [0.01, 1] step *2, units: spacing of the lines of equal distance
uniform int   maxSteps;     // 256 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.004 in [0.00001, 0.1] step *2, units: distance that counts as a hit

const float FAR = 6.0; // a ray that has travelled this far has left the sheet

// The point of the sheet, the plane z = 0, that a point of the screen shows. The camera stays in
// front of the sheet. For a ray above the horizon, which misses the sheet, the result is a point far
// away.
vec2 planePoint(vec2 screen)
{
    vec3 way = screen.x * iCameraRight + screen.y * iCameraUp + focalLength * iCameraForward;
    return iCameraPosition.xy - max(iCameraPosition.z, 0.01) / min(way.z, -0.001) * way.xy;
}

// How far the point of the sheet moves when the point of the screen moves, to first order: the
// derivative of planePoint.
//   p     the point of the sheet
//   move  direction in which the point of the screen moves: the camera's right or up
//   away  how far the point of the screen moves, times the distance from the camera to the sheet
//         along the view, in focal lengths
vec2 sheetStep(vec2 p, vec3 move, float away)
{
    return away * (move.xy + move.z * (p - iCameraPosition.xy) / max(iCameraPosition.z, 0.01));
}

// All rays lie in the sheet. The picture, the probe, the slice view and the plot use one ray for all
// pixels, through aim. In the views of the normals, the depth and the steps, each pixel has a ray
// through the point that it shows. Only VIEW_POSITIONS, which finds the handles in the picture,
// needs the rays from the eye.
Ray pixelRay(vec2 screen)
{
#if VIEW == VIEW_POSITIONS
    return perspectiveRay(screen);
#else
    vec2 way = (VIEW_OF_TRACE ? planePoint(screen) : aim) - rayStart;
    return Ray(vec3(rayStart, 0.0), normalize(vec3(way + 1e-7, 0.0)));
#endif
}

// ---- The figure ----

const vec2 DART[POLYGON_CORNERS] = vec2[POLYGON_CORNERS](
    vec2(-0.9, 0.1), vec2(0.7, 0.8), vec2(0.2, 0.0), vec2(0.6, -0.8), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0),
    vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0));

// The distance to the disc, the bar, the rectangle or the point. The disc is a rounded rectangle of
// size zero, and the bar is one of height zero. The rectangle and the point, which is a rectangle of
// size zero, are not rounded.
float roundedDistance(vec2 p)
{
    vec2 halfSize = figure == 2 ? vec2(0.9, 0.55) : vec2(figure == 1 ? 0.9 : 0.0, 0.0);
    return opRound(sdRectangle(p, halfSize), figure == 0 ? 0.8 : (figure == 1 ? 0.015 : 0.0));
}

// Four pairs of lobes on a stem; abs folds the left lobes onto the right ones. A lobe is a segment
// enlarged by a width, and blends smoothly with the parts that it meets.
float leafDistance(vec2 p)
{
    p = mat2(0.891, -0.454, 0.454, 0.891) * (p - vec2(0.24, -0.02)); // turned by 27 degrees
    p.x = abs(p.x);
    float d = opRound(sdSegment(p, vec2(0.0, -1.25), vec2(0.0, 1.02)), 0.05);
    for (int i = 0; i < 4; i++) {
        float s = float(i);
        vec2 base = vec2(0.0, -0.74 + 0.42 * s);
        vec2 tip = base + (0.82 + 0.12 * s - 0.085 * s * s) * vec2(0.84 - 0.05 * s, 0.36 + 0.11 * s);
        d = opSmoothUnion(d, opRound(sdSegment(p, base, tip), 0.12 - 0.012 * s), 0.14);
    }
    return d;
}

float figureDistance(vec2 p)
{
    float d = figure <= 2 || figure == 8 ? roundedDistance(p) : leafDistance(p);
    d = figure == 3 ? sdTriangle(p, vec2(-0.9, -0.6), vec2(0.9, -0.6), vec2(-0.3, 0.8)) : d;
    d = figure == 4 ? sdPolygon(p, DART, 4) : d;
    d = figure == 5 ? opRound(sdArc(p, 0.7, 2.0), 0.015) : d;
    return figure == 7 ? p.y : d;
}

float sheetDistance(vec2 p)
{
    float a = figureDistance(p), disc = sdCircle(p - vec2(0.8, -0.3), 0.5);
    float d = operation == 1 ? opUnion(a, disc) : a;
    d = operation == 2 ? opIntersection(a, disc) : d;
    d = operation == 3 ? opSubtraction(a, disc) : d;
    d = operation == 4 ? opSmoothUnion(a, disc, amount) : d;
    d = operation == 5 ? opOnion(a, amount) : d;
    d = operation == 6 ? opRound(a, amount) : d;
    return mix(d, disc, morph);
}

float sceneDistance(vec3 p)
{
    return sheetDistance(p.xy);
}

// ---- The print ----

// Colours, linear RGB.
const vec3 PAPER    = vec3(0.91, 0.79, 0.57);
const vec3 GLOW     = vec3(0.76, 0.24, 0.05); // outside, near the figure
const vec3 EDGE     = vec3(0.07, 0.25, 0.48); // inside, near the outline
const vec3 DEEP     = vec3(0.006, 0.03, 0.10);
const vec3 LINE_OUT = vec3(0.30, 0.07, 0.015);
const vec3 LINE_IN  = vec3(0.55, 0.75, 0.95);
const vec3 OUTLINE  = vec3(1.0, 0.97, 0.88);
const vec3 INK      = vec3(0.012, 0.010, 0.025);

// The share of a pixel that a line covers.
//   x      distance from the middle of the line, in pixels
//   width  in pixels of a picture with 360 rows
float line(float x, float width)
{
    return coverage(0.5 * width * max(iResolution.y / 360.0, 1.0) - abs(x), 1.0);
}

// The distance at p as colours, lines and an outline. Lines have a fixed width in pixels, because d
// is divided by its change from pixel to pixel. Where lines would be too close together, they fade.
//   right, up  the points that the neighbouring pixels show
vec3 fieldColour(vec2 p, vec2 right, vec2 up)
{
    float d = distanceAt(vec3(p, 0.0));
    float perPixel = length(vec2(distanceAt(vec3(right, 0.0)), distanceAt(vec3(up, 0.0))) - d);
    perPixel = max(perPixel, 0.25 * length(right - p)); // a lower limit for ridges, where the change vanishes
    float near = exp(-abs(d) / (d > 0.0 ? 0.3 : 0.06));
    vec3 light = d > 0.0 ? mix(PAPER, GLOW, near) : mix(DEEP, EDGE, near);
    float level = floor(d / lineSpacing + 0.5);
    bool fifth = mod(level, 5.0) == 0.0;
    float ink = line((d - level * lineSpacing) / perPixel, fifth ? 1.3 : 0.8);
    ink *= (fifth ? 0.6 : 0.35) * (1.0 - blurred(perPixel / lineSpacing));
    light = mix(light, d > 0.0 ? LINE_OUT : LINE_IN, ink);
    return mix(light, OUTLINE, line(d / perPixel, 2.6));
}

// The march, drawn over a colour: the area that its circles prove empty, the circles, the ray up to
// the last evaluation, and ticks where fixed steps would evaluate the distance.
//   right, up  vectors from p to the points that the neighbouring pixels show, units
vec3 marchColour(vec3 light, vec2 p, vec2 right, vec2 up, Ray ray)
{
    mat2 turn = mat2(ray.direction.xy, -ray.direction.y, ray.direction.x);
    vec2 q = (p - ray.origin.xy) * turn; // coordinates along the ray and perpendicular to it
    mat2 next = mat2(right * turn, up * turn);
    vec2 pixel = vec2(length(vec2(next[0].x, next[1].x)), length(vec2(next[0].y, next[1].y)));
    int steps = marchedSteps(ray, FAR, hitThreshold, maxSteps);
    float circle = 1e6, inside = 1e6, t = 0.0, end = 0.0;
    float middle = 0.0; // t at the centre of the circle whose rim is nearest
    for (int k = 0; k < steps; k++) {
        float radius = marchedStep(k).y, outside = length(q - vec2(t, 0.0)) - radius;
        inside = min(inside, outside);
        middle = abs(outside) < circle ? t : middle;
        circle = min(circle, abs(outside));
        end = t;
        t += radius;
    }
    vec2 across = q - vec2(middle, 0.0) + 1e-7, move = across * next;
    float perUnit = sqrt(dot(across, across) / dot(move, move)); // pixels per unit, perpendicular to the rim
    float ink = q.x > 0.0 && q.x < end ? line(q.y / pixel.y, 1.2) : 0.0;
    if (fixedStep > 0.0 && q.x > 0.0 && abs(q.y) < 5.0 * pixel.y)
        ink = max(ink, line((fract(q.x / fixedStep + 0.5) - 0.5) * fixedStep / pixel.x, 1.2));
    if (marchedHit())
        ink = max(ink, line(length((q - vec2(end, 0.0)) / pixel) - 5.0, 1.1));
    ink = max(ink, coverage(4.0 - length(q / pixel), 1.0));
    light = mix(light, OUTLINE, 0.35 * coverage(-inside * perUnit, 1.0));
    return mix(light, INK, max(ink, line(circle * perUnit, 1.1)));
}

vec3 rayColour(Ray ray)
{
#if VIEW_OF_TRACE || VIEW == VIEW_SLICE || VIEW == VIEW_PLOT || VIEW == VIEW_PROBE
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    if (VIEW == VIEW_DEPTH) // the greys of the depth view change most around 6 units, so scale the sheet by 4
        traceMarch(trace.steps, 4.0 * hit.t, trace.end);
    if (VIEW_OF_TRACE && hit.found)
        normalAt(ray.origin + hit.t * ray.direction, hitThreshold);
    return PAPER;
#else
    vec2 screen = screenPosition(gl_FragCoord.xy + iPixelOffset), p = planePoint(screen);
    float down = screen.x * iCameraRight.z + screen.y * iCameraUp.z + focalLength * iCameraForward.z;
    float away = max(iCameraPosition.z, 0.01) / max(-down, 0.001) * 2.0 / iResolution.y;
    vec2 right = sheetStep(p, iCameraRight, away), up = sheetStep(p, iCameraUp, away);
    float wide = down < -0.001 ? max(length(right), length(up)) : 1.0; // a pixel wider than a unit shows only paper
    vec3 light = marchColour(fieldColour(p, p + right, p + up), p, right, up, ray);
    return encodeSRGB(mix(light, PAPER, blurred(wide)));
#endif
}
