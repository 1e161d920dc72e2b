// Experiment of chapter 04: a diagram, in the plane, of what min and max do to the distances of two
// discs. Dark lines connect points where the operation gives the same value, and white lines
// connect points at the same true distance. The difference is shown in red, which is strongest
// where the difference is at least 0.25. Where no white line is visible, the two kinds of line
// coincide, and the operation is exact. For the smooth union, only the dark lines are drawn.
//
// The true distance is the smallest of the distances to the pieces of the boundary: the remaining
// part of each circle, and the two points where the circles cross.
#include "main.glsl"
#include "camera.glsl"
#include "primitives.glsl"
#include "combine.glsl"

uniform int   operation; // 1 in [0, 3]: 0 union, 1 intersection, 2 left minus right, 3 smooth union
uniform float apart;     // 0.7 in [0.1, 0.95] step 0.05, scene units: from the middle to each centre
uniform float blend;     // 0.6 in [0.01, 1.5] step 0.05, scene units: width of the smooth union's blend

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float combined(vec3 p)
{
    float a = sdSphere(p + vec3(apart, 0.0, 0.0), 1.0), b = sdSphere(p - vec3(apart, 0.0, 0.0), 1.0);
    if (operation == 0)
        return opUnion(a, b);
    if (operation == 1)
        return opIntersection(a, b);
    return operation == 2 ? opSubtraction(a, b) : opSmoothUnion(a, b, blend);
}

float sceneDistance(vec3 p)
{
    return combined(p);
}

// The distance from q to the part that remains of the circle around the origin: the distance to the
// circle if its point nearest to q remains, otherwise a very large number.
//   other   the centre of the other circle
//   inside  true if the part inside the other disc remains, false if the part outside remains
float arcDistance(vec2 q, vec2 other, bool inside)
{
    bool left = (length(normalize(q) - other) < 1.0) == inside;
    return left ? abs(length(q) - 1.0) : 1e6;
}

float trueDistance(vec2 p)
{
    vec2 centre = vec2(apart, 0.0);
    float a = arcDistance(p + centre, 2.0 * centre, operation == 1);
    float b = arcDistance(p - centre, -2.0 * centre, operation != 0);
    float corner = length(vec2(p.x, abs(p.y) - sqrt(1.0 - apart * apart)));
    return min(corner, min(a, b)) * sign(combined(vec3(p, 0.0)));
}

// Lines where a distance is a multiple of 0.25; the line at 0 is thicker. Returns the share of the
// pixel that the lines cover, from 0 to 1.
float levels(float distance, float pixel)
{
    float nearest = 0.25 * floor(4.0 * distance + 0.5);
    float width = nearest == 0.0 ? 3.0 : 1.2;
    return clamp(0.5 * width + 0.5 - abs(distance - nearest) / pixel, 0.0, 1.0);
}

vec3 rayColour(Ray ray)
{
    vec2 p = 2.0 * screenPosition(gl_FragCoord.xy + iPixelOffset);
    float pixel = 4.0 / iResolution.y;
    float asked = combined(vec3(p, 0.0)), truth = operation == 3 ? asked : trueDistance(p);
    vec3 colour = asked < 0.0 ? vec3(0.62, 0.72, 0.84) : vec3(0.95, 0.93, 0.88);
    float wrong = clamp(4.0 * abs(truth - asked), 0.0, 1.0);
    colour = mix(colour, vec3(0.86, 0.30, 0.22), 0.8 * wrong);
    colour = mix(colour, vec3(1.0), 0.9 * levels(truth, pixel));
    return mix(colour, vec3(0.07, 0.10, 0.20), (operation == 3 ? 1.0 : 0.85) * levels(asked, pixel));
}
