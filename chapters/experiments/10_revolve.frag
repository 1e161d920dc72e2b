// Experiment of chapter 10: a disc of radius 1 is revolved about the y axis, and shown in a plane
// through this axis. Left of the axis nothing is evaluated and nothing is drawn, but the part of
// the disc there still affects the distance.
//
// Dark lines show the distance that the formula gives, and white lines show the distance to the
// surface that is drawn. Red shows the difference, and is strongest where it is at least 0.25.
// Where no white line is visible, the two distances coincide.
#include "main.glsl"
#include "camera.glsl"
#include "plane.glsl"  // sdCircle, sdArc
#include "solids.glsl" // opRevolve

uniform float centre; // 0.8 in [-0.95, 1.5] step 0.05, scene units: from the axis to the centre of the disc

const vec3 INK = vec3(0.07, 0.10, 0.20);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    return sdCircle(opRevolve(p, 0.0) - vec2(centre, 0.0), 1.0);
}

// The distance to the part of the rim that is revolved, an arc centred on the x axis; negative
// inside.
float drawnDistance(vec2 q)
{
    float half_ = atan(sqrt(max(1.0 - centre * centre, 0.0)), -centre); // acos(-centre); pi if centre >= 1
    float rim = sdArc(vec2(q.y, q.x - centre), 1.0, half_);
    return sdCircle(q - vec2(centre, 0.0), 1.0) < 0.0 ? -rim : rim;
}

// The share of a pixel that a line covers.
//   distance  from the middle of the line, pixels
//   width     of the line, pixels
float line(float distance, float width)
{
    return clamp(0.5 * width + 0.5 - abs(distance), 0.0, 1.0);
}

// Lines where a distance is a multiple of 0.1; the line at 0 is thicker. Returns the share of the
// pixel that the lines cover, from 0 to 1.
float levels(float distance, float pixel)
{
    float nearest = 0.1 * floor(10.0 * distance + 0.5);
    return line((distance - nearest) / pixel, nearest == 0.0 ? 3.0 : 1.2);
}

vec3 rayColour(Ray ray)
{
    vec2 p = 1.7 * screenPosition(gl_FragCoord.xy + iPixelOffset) + vec2(0.9, 0.0);
    float pixel = 3.4 / iResolution.y, left = clamp(0.5 - p.x / pixel, 0.0, 1.0);
    float asked = distanceAt(vec3(p, 0.0)), drawn = drawnDistance(vec2(abs(p.x), p.y));
    vec3 colour = asked < 0.0 ? vec3(0.90, 0.62, 0.42) : vec3(0.95, 0.93, 0.88);
    colour = mix(colour, vec3(0.80, 0.10, 0.12), 0.85 * clamp(4.0 * abs(drawn - asked), 0.0, 1.0));
    colour = mix(colour, vec3(1.0), 0.9 * levels(drawn, pixel));
    colour = mix(colour, INK, 0.85 * levels(asked, pixel));
    // Left of the axis: the plane of the figure, with a dashed line for the part of the circle that
    // is not revolved.
    float whole = sdCircle(p - vec2(centre, 0.0), 1.0);
    float angle = atan(p.y, p.x - centre + float(p == vec2(centre, 0.0)));
    float dash = fract(16.0 * angle / 3.14159265) < 0.6 ? line(whole / pixel, 2.0) : 0.0;
    colour = mix(colour, mix(vec3(0.80, 0.79, 0.77), INK, dash), left);
    return mix(colour, INK, line(p.x / pixel, 2.0));
}
