// Experiment of chapter 10: a figure is extruded, and turns and shrinks with increasing height. The
// function looks like that of an extrusion but is not a distance: its value can change by more than
// the point moves.
#include "main.glsl"
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "combine.glsl"    // opIntersection, opUnion
#include "plane.glsl"      // sdRectangle, opRound
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach, lightReaching

uniform float twist;        // 3 in [0, 6] step 0.2, radians per scene unit of height: rate at which the figure turns
uniform float taper;        // 0.3 in [0, 0.45] step 0.05, per scene unit of height: rate at which the figure shrinks
uniform float factor;       // 1 in [0.1, 1] step 0.05: factor for the distance to the wall
uniform int   maxSteps;     // 400 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0002 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

const float HEIGHT = 2.0;
const float REACH = 0.62; // no point of the figure is farther than this from its centre, scene units
const vec3  TO_LAMP = vec3(-0.66, 0.50, 0.56);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// A cross of two bars with rounded corners. The distance is exact outside.
float figure(vec2 q)
{
    float bars = min(sdRectangle(q, vec2(0.50, 0.05)), sdRectangle(q, vec2(0.05, 0.50)));
    return opRound(bars, 0.11);
}

// The distance in the plane to the figure as it is turned and scaled at the height of p. The
// function is zero on the wall, but it is not a distance to the wall.
float wallFunction(vec3 p)
{
    float y = clamp(p.y, 0.0, HEIGHT), size = 1.0 - taper * y, c = cos(twist * y), s = sin(twist * y);
    vec2 q = vec2(c * p.x + s * p.z, c * p.z - s * p.x) / size;
    return size * figure(q);
}

float columnDistance(vec3 p)
{
    return opIntersection(factor * wallFunction(p), p.y - HEIGHT);
}

float sceneDistance(vec3 p)
{
    return opUnion(columnDistance(p), p.y);
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, 30.0, hitThreshold, maxSteps);
    vec3 paper = vec3(0.80, 0.74, 0.65);
    if (!hit.found)
        return encodeSRGB(paper);
    vec3 p = ray.origin + hit.t * ray.direction, normal = normalAt(p, 0.001);
    Ray next = shadowRay(p, normal, TO_LAMP, 0.01);
    float seen = lightReaching(next, shadowReach(normal, TO_LAMP, 8.0), hitThreshold, maxSteps);
    vec3 light = vec3(1.05, 0.94, 0.78) * seen * lambert(normal, TO_LAMP) + vec3(0.09, 0.12, 0.19);
    vec3 colour = columnDistance(p) < p.y ? vec3(0.60, 0.14, 0.035) : paper;
    return encodeSRGB(mix(paper, colour * light, exp(-0.0015 * hit.t * hit.t)));
}
