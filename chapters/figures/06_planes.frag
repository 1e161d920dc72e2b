// A cut through a tetrahedron, along one edge and through the middle of the opposite edge: drag the point. The radius
// of the green circle is the exact distance, and that of the blue circle is the distance computed from the planes of
// the faces; at the top left is the ratio of the second to the first. The pale lines connect points where the distance
// from the planes is equal or, if the parameter `exactLines` is on, where the exact distance is equal.
#include "figure.glsl"
#include "symmetry.glsl"

uniform vec2 point;      // (0.86, -0.508) handle: where the distances are evaluated
uniform bool exactLines; // false: draw the lines of the exact distance

const float SIZE = 0.36; // size of the tetrahedron, as in symmetry.glsl

// The point in space that corresponds to a point of the cut. The cut is a triangle: its lower corners are corners of
// the tetrahedron, its lower side is an edge, and its upper corner is the middle of the opposite edge.
vec3 inSpace(vec2 p)
{
    p.y -= 0.1;
    return vec3(-p.y, 0.70710678 * p.x, 0.70710678 * p.x);
}

float sceneDistance(vec3 p)
{
    return exactLines ? sdTetrahedron(inSpace(p.xy), SIZE) : sdTetrahedronPlanes(inSpace(p.xy), SIZE);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0));
    float planes = sdTetrahedronPlanes(inSpace(point), SIZE), exact = sdTetrahedron(inSpace(point), SIZE);
    fill(d, SAND, 1.0);
    contours(d, 0.1, 0.8, PALE);
    fill(length(p - point) - abs(exact), SKY, 0.7);
    stroke(d, 2.5, ORANGE);
    stroke(length(p - point) - abs(exact), 1.5, TEAL);
    stroke(length(p - point) - abs(planes), 1.5, BLUE);
    dot2(p, point, 8.0, INK);
    number(p, vec2(-1.6, 0.88), planes / (abs(exact) > 1e-4 ? exact : 1e-4), 3, INK); // ratio #
    return sheetColour;
}
