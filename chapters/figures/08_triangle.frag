// The impossible triangle: drag the dot to turn the view. Three beams of equal length, each at right angles to the
// previous one, end far behind their beginning. In the isometric view, when the dot is in the ring, the end and the
// beginning coincide in the picture. The first beam is cut along the direction of this view, so that the last beam
// seems to join it.
#include "figure.glsl"
#include "march.glsl"
#include "normal.glsl"

uniform vec2 view; // (0.0, 0.0) handle: turns the view; in the middle it is isometric

const float LENGTH = 5.0;                                       // distance between the centres of two corners
const vec3  CENTRE = vec3(2.0 / 3.0, -1.0 / 3.0, 0.0) * LENGTH; // centre of the picture
const float SCALE = 3.1;                                        // scene units per unit of the sheet

// A lower bound of the distance to a beam of width 1, computed without roots.
float beam(vec3 p, vec3 centre, vec3 axis)
{
    vec3 q = abs(p - LENGTH * centre) - 0.5 - 0.5 * LENGTH * axis;
    return max(q.x, max(q.y, q.z));
}

// The points that are in front of or behind the last beam in the isometric view: the intersection of three slabs whose
// faces are parallel to the direction (1, -1, -1) of this view.
float shaft(vec3 p)
{
    vec3 q = p - LENGTH * vec3(1.0, -1.0, -0.5);
    vec3 across = abs(vec3(q.x + q.y, q.x + q.z, q.y - q.z) + vec3(0.01, 0.01, -0.01));
    vec3 slabs = across - vec3(1.0, 1.0 + 0.5 * LENGTH, 1.0 + 0.5 * LENGTH);
    return max(slabs.x, max(slabs.y, slabs.z)) * 0.70710678;
}

float sceneDistance(vec3 p)
{
    float first = opSubtraction(beam(p, vec3(0.5, 0.0, 0.0), vec3(1.0, 0.0, 0.0)), shaft(p));
    float second = beam(p, vec3(1.0, -0.5, 0.0), vec3(0.0, 1.0, 0.0));
    return min(first, min(second, beam(p, vec3(1.0, -1.0, -0.5), vec3(0.0, 0.0, 1.0))));
}

// The ray of a parallel view in a direction given by its pan and tilt in degrees.
Ray parallelRay(vec2 p, float pan, float tilt)
{
    vec2 turn = radians(vec2(pan, tilt)), c = cos(turn), s = sin(turn);
    vec3 forward = vec3(s.x * c.y, s.y, -c.x * c.y), right = vec3(c.x, 0.0, s.x);
    vec3 across = p.x * right + p.y * cross(right, forward);
    return Ray(CENTRE + SCALE * across - 9.0 * forward, forward);
}

// The colour at a point of the sheet: a face has one of three colours, according to its direction.
vec3 sampleColour(vec2 p)
{
    vec2 turned = length(view) < 0.04 ? vec2(0.0) : view;
    Ray ray = parallelRay(p, 45.0 + 40.0 * turned.x, -35.26439 + 40.0 * turned.y);
    Hit hit = march(ray, 0.0, 18.0, 0.001, 256);
    if (hit.t >= 18.0) // a ray that runs out of steps grazes a face and counts as a hit
        return PAPER;
    vec3 normal = normalAt(ray.origin + hit.t * ray.direction, 0.0005);
    if (abs(dot(normal, ray.direction)) < 0.1)
        return SAND; // a face seen edge-on has the colour of the upper face, which begins here
    return mat3(ORANGE, SAND, vec3(0.45, 0.22, 0.07)) * (normal * normal);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    vec2 beside = sheetPixel() * vec2(0.27, 0.13); // two samples per pixel
    sheetColour = 0.5 * (sampleColour(p - beside) + sampleColour(p + beside));
    stroke(length(p) - 0.06, 1.5, TEAL);
    dot2(p, view, 8.0, INK);
    return sheetColour;
}
